cell_add_test(sim/articulated_test.cc LINK cell_vtb cell_sec cell_tracker)
