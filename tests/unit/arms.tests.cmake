cell_add_test(unit/ur5_test.cc LINK cell_arms)
cell_add_test(unit/aim_error_test.cc LINK cell_robot_arm)
