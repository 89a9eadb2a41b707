cell_add_test(unit/tracker/ideal_tracker_test.cc LINK cell_tracker)
