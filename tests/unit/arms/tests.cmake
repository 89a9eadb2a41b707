cell_add_test(unit/arms/joint_trajectory_test.cc LINK cell_arms)
cell_add_test(unit/arms/arm_scene_test.cc LINK cell_arms cell_tracker)
cell_add_test(unit/arms/path_planner_test.cc LINK cell_arms cell_tracker)
cell_add_test(unit/arms/reach_test.cc LINK cell_arms cell_tracker)
cell_add_test(unit/arms/cell_reach_test.cc
  LINK cell_arms cell_rendering cell_tracker cell_vtb)
cell_add_test(unit/arms/motion_messages_test.cc LINK cell_motion_planner cell_tracker)
