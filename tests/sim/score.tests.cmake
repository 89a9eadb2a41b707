cell_add_test(sim/score_test.cc LINK cell_cli cell_vtb cell_sec cell_tracker TIMEOUT 600)
