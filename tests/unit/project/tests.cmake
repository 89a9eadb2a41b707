cell_add_test(unit/project/purity_test.cc LINK fmt::fmt)
cell_add_test(unit/project/definitions_test.cc)
cell_add_test(unit/project/class_size_test.cc)
cell_add_test(unit/project/copying_test.cc
  LINK cell_cli cell_robot_arm cell_motion_planner cell_planner cell_vtb cell_camera_set
    cell_library)
cell_add_test(unit/project/watching_services_test.cc
  LINK cell_tracker cell_sec_builder cell_recognizer cell_predicate_estimator
    cell_planner)
