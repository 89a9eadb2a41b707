cell_add_test(unit/assembly_score_test.cc LINK cell_cli cell_vtb cell_sec)
