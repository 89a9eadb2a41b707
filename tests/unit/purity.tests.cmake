cell_add_test(unit/purity_test.cc LINK fmt::fmt)
cell_add_test(unit/definitions_test.cc)
cell_add_test(unit/class_size_test.cc)
cell_add_test(unit/copying_test.cc
  LINK cell_cli cell_robot_arm cell_motion_planner cell_planner cell_vtb cell_camera_set
    cell_library)
