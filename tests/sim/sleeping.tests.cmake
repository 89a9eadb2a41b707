cell_add_test(sim/sleeping_test.cc LINK cell_vtb TIMEOUT 600)
