cell_add_test(unit/supervisor/supervisor_test.cc LINK cell_supervisor)
