cell_add_test(unit/predicates/predicate_sensor_test.cc LINK cell_sec cell_task)
cell_add_test(unit/predicates/seat_test.cc LINK cell_sec)
cell_add_test(unit/predicates/rules_and_sensing_test.cc LINK cell_planner cell_sec cell_task)
