cell_add_test(unit/assembly_score_test.cc LINK cell_cli cell_vtb cell_sec)
cell_add_test(unit/motion_check_test.cc LINK cell_cli cell_arms cell_geometry cell_sec cell_tracker)
cell_add_test(unit/assembly_observer_test.cc LINK cell_cli cell_vtb cell_geometry cell_sec cell_tracker)
