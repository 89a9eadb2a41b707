cell_add_test(unit/supervisor_test.cc LINK cell_supervisor)
