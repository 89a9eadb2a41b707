cell_add_test(unit/action_store_test.cc LINK cell_library SQLiteCpp)
cell_add_test(unit/action_record_test.cc LINK cell_library cell_tracker)
cell_add_test(unit/library_test.cc
  LINK cell_library cell_recorder cell_tracker)
cell_add_test(unit/action_records_test.cc
  LINK cell_planner cell_recognizer cell_task cell_tracker)
