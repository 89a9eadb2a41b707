cell_add_test(unit/sec_messages_test.cc LINK cell_sec)
