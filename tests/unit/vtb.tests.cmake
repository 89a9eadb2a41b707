cell_add_test(unit/thread_engagement_test.cc LINK cell_vtb)
cell_add_test(unit/arm_servo_test.cc LINK cell_vtb)
cell_add_test(unit/hand_path_test.cc LINK cell_vtb)
cell_add_test(unit/script_test.cc LINK cell_vtb)
