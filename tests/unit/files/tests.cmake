cell_add_test(unit/files/temporary_folder_test.cc LINK cell_files)
cell_add_test(unit/files/new_file_test.cc LINK cell_files)
