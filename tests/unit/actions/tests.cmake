cell_add_test(unit/actions/action_record_test.cc LINK cell_library cell_tracker)
cell_add_test(unit/actions/action_records_test.cc
  LINK cell_planner cell_recognizer cell_task cell_tracker)
cell_add_test(unit/actions/skill_needs_test.cc LINK cell_actions)
