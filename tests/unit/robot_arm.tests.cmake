cell_add_test(unit/scene_monitor_test.cc LINK cell_robot_arm cell_motion_planner cell_tracker)
cell_add_test(unit/motion_client_test.cc LINK cell_robot_arm cell_motion_planner cell_tracker)
cell_add_test(unit/robot_arm_start_test.cc
  LINK cell_robot_arm cell_bus cell_tracker)
cell_add_test(unit/aim_error_test.cc LINK cell_robot_arm)
cell_add_test(unit/yield_policy_test.cc LINK cell_robot_arm)
cell_add_test(unit/fastening_test.cc LINK cell_robot_arm cell_bus cell_tracker)
cell_add_test(unit/reachable_test.cc
  LINK cell_robot_arm cell_motion_planner cell_tracker cell_vtb)
cell_add_test(unit/admittance_test.cc LINK cell_robot_arm)
cell_add_test(unit/contact_search_test.cc LINK cell_robot_arm)
cell_add_test(unit/contact_reference_test.cc LINK cell_robot_arm)
cell_add_test(unit/contact_motion_test.cc LINK cell_robot_arm cell_tracker)
cell_add_test(unit/skill_settings_test.cc LINK cell_robot_arm cell_tracker)
