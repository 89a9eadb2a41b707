cell_add_test(unit/predicate_sensor_test.cc LINK cell_sec cell_task)
cell_add_test(unit/seat_test.cc LINK cell_sec)
