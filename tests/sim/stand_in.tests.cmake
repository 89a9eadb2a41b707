cell_add_test(sim/stand_in_test.cc LINK cell_cli cell_vtb cell_sec TIMEOUT 600)
