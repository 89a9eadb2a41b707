cell_add_test(sim/robot_arm_test.cc LINK cell_cli cell_robot_arm cell_motion_planner cell_tracker cell_vtb cell_sec TIMEOUT 600)
