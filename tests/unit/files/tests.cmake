cell_add_test(unit/files/temporary_folder_test.cc LINK cell_files)
