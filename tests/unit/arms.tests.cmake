cell_add_test(unit/joint_trajectory_test.cc LINK cell_arms)
cell_add_test(unit/arm_scene_test.cc LINK cell_arms cell_tracker)
cell_add_test(unit/path_planner_test.cc LINK cell_arms cell_tracker)
cell_add_test(unit/reach_test.cc LINK cell_arms cell_tracker)
cell_add_test(unit/cell_reach_test.cc
  LINK cell_arms cell_rendering cell_tracker cell_vtb)
