cell_add_test(sim/operator_answers_test.cc
  LINK cell_cli cell_vtb cell_sec TIMEOUT 600)
