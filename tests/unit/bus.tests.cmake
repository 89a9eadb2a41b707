cell_add_test(unit/stepper_test.cc LINK cell_bus)
cell_add_test(unit/lockstep_test.cc LINK cell_bus)
cell_add_test(unit/event_log_test.cc LINK cell_bus)
cell_add_test(unit/config_test.cc LINK cell_config)
