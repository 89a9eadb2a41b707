cell_add_test(unit/vtb/thread_engagement_test.cc LINK cell_vtb)
cell_add_test(unit/vtb/arm_servo_test.cc LINK cell_vtb)
cell_add_test(unit/vtb/hand_path_test.cc LINK cell_vtb)
cell_add_test(unit/vtb/script_test.cc LINK cell_vtb)
