cell_add_test(fuzz/forged_messages_test.cc LINK cell_cli TIMEOUT 1500)
