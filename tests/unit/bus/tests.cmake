cell_add_test(unit/bus/episode_gate_test.cc LINK cell_bus)
cell_add_test(unit/bus/stepper_test.cc LINK cell_bus)
cell_add_test(unit/bus/lockstep_test.cc LINK cell_bus)
cell_add_test(unit/bus/event_log_test.cc LINK cell_bus)
cell_add_test(unit/bus/arrivals_test.cc LINK cell_bus)
cell_add_test(unit/bus/channel_filter_test.cc LINK cell_bus)
cell_add_test(unit/bus/live_test.cc LINK cell_bus)
cell_add_test(unit/bus/follow_node_test.cc LINK cell_bus)
cell_add_test(unit/bus/robot_planner_test.cc LINK cell_planner cell_parts)
cell_add_test(unit/bus/copying_test.cc
  LINK cell_cli cell_robot_arm cell_motion_planner cell_planner cell_vtb cell_camera_set
    cell_library)
cell_add_test(unit/bus/robot_arm_start_test.cc
  LINK cell_robot_arm cell_bus cell_tracker)
cell_add_test(unit/bus/watching_services_test.cc
  LINK cell_tracker cell_sec_builder cell_recognizer cell_predicate_estimator
    cell_planner)
