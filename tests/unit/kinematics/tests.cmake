cell_add_test(unit/kinematics/arm_model_test.cc LINK cell_kinematics)
