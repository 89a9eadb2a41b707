cell_add_test(unit/library/action_store_test.cc LINK cell_library SQLiteCpp)
cell_add_test(unit/library/library_test.cc
  LINK cell_library cell_recorder cell_tracker)
cell_add_test(unit/library/record_edits_test.cc LINK cell_library SQLiteCpp)
cell_add_test(unit/library/experience_check_test.cc LINK cell_library)
cell_add_test(unit/library/experience_json_test.cc LINK cell_library)
