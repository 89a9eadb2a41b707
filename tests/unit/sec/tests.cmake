cell_add_test(unit/sec/event_chain_test.cc LINK cell_sec)
