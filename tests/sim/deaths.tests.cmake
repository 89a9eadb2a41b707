cell_add_test(sim/deaths_test.cc LINK cell_cli cell_vtb cell_sec TIMEOUT 900)
cell_add_test(sim/hold_and_resume_test.cc
  LINK cell_cli cell_vtb cell_sec TIMEOUT 900)
cell_add_test(sim/stops_test.cc LINK cell_cli cell_vtb cell_sec TIMEOUT 900)
