cell_add_test(unit/ideal_tracker_test.cc LINK cell_tracker)
