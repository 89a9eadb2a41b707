cell_add_test(unit/motion_planner/motion_search_test.cc LINK cell_motion_planner cell_tracker)
cell_add_test(unit/motion_planner/motion_planner_test.cc LINK cell_motion_planner cell_tracker)
cell_add_test(unit/motion_planner/reachable_test.cc
  LINK cell_robot_arm cell_motion_planner cell_tracker cell_vtb)
