cell_add_test(unit/sec_messages_test.cc LINK cell_sec cell_task)
cell_add_test(unit/event_chain_test.cc LINK cell_sec)
