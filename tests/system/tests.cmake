cell_add_test(system/lcm_lockstep_test.cc LINK cell_bus Threads::Threads)
cell_add_test(system/cell_command_test.cc LINK cell_bus TIMEOUT 900)
add_dependencies(cell_command_test programs)
cell_add_test(system/execution_command_test.cc LINK cell_bus TIMEOUT 900)
add_dependencies(execution_command_test programs)
cell_add_test(system/library_kill_test.cc LINK cell_library TIMEOUT 300)
cell_add_test(system/library_death_test.cc
  LINK cell_cli cell_library cell_recorder cell_tracker Threads::Threads)
add_dependencies(library_death_test library)
cell_add_test(system/library_command_test.cc
  LINK cell_library cell_tracker TIMEOUT 300)
add_dependencies(library_command_test programs)
