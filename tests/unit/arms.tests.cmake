cell_add_test(unit/ur5_test.cc LINK cell_arms)
