cell_add_test(unit/task/learned_rules_test.cc LINK cell_task cell_tracker)
