cell_add_test(unit/arm_model_test.cc LINK cell_kinematics)
