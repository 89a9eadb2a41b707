cell_add_test(system/lcm_lockstep_test.cc LINK cell_bus Threads::Threads)
if(TARGET cell_cli)
  cell_add_test(system/cell_command_test.cc LINK cell_bus TIMEOUT 900)
  add_dependencies(cell_command_test cell vtb tracker sec_builder recognizer
    predicate_estimator planner recorder)
endif()
