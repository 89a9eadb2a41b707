cell_add_test(sim/world_test.cc LINK cell_vtb)
cell_add_test(sim/demonstrator_test.cc LINK cell_vtb TIMEOUT 600)
cell_add_test(sim/vtb_test.cc LINK cell_vtb TIMEOUT 600)
