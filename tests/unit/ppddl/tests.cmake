cell_add_test(unit/ppddl/ppddl_parser_test.cc LINK cell_ppddl)
cell_add_test(unit/ppddl/ppddl_round_trip_test.cc LINK cell_ppddl)
