cell_add_test(unit/arm_planner_test.cc LINK cell_robot_arm cell_tracker)
