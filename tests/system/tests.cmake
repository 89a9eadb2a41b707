cell_add_test(system/lcm_lockstep_test.cc LINK cell_bus Threads::Threads)
cell_add_test(system/cell_command_test.cc LINK cell_bus TIMEOUT 900)
add_dependencies(cell_command_test programs)
cell_add_test(system/camera_command_test.cc
  LINK cell_bus cell_imaging TIMEOUT 900)
add_dependencies(camera_command_test programs)
cell_add_test(system/execution_command_test.cc LINK cell_bus TIMEOUT 900)
add_dependencies(execution_command_test programs)
