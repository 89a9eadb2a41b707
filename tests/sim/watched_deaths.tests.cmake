cell_add_test(sim/watched_deaths_test.cc
  LINK cell_cli cell_vtb cell_sec TIMEOUT 600)
