cell_add_test(unit/pair_filter_test.cc LINK cell_sec_builder)
cell_add_test(unit/key_frame_extractor_test.cc LINK cell_sec_builder)
cell_add_test(unit/proximity_test.cc LINK cell_sec_builder cell_tracker)
cell_add_test(unit/watching_services_test.cc
  LINK cell_tracker cell_sec_builder cell_recognizer cell_predicate_estimator
    cell_planner)
