cell_add_test(fuzz/forged_messages_test.cc LINK cell_cli cell_imaging TIMEOUT 1500)
