cell_add_test(system/lcm_lockstep_test.cc LINK cell_bus Threads::Threads)
cell_add_test(system/lcm_receiver_test.cc LINK cell_bus)
cell_add_test(system/cell_command_test.cc LINK cell_bus cell_imaging TIMEOUT 1500)
add_dependencies(cell_command_test programs)
cell_add_test(system/output_test.cc LINK cell_bus TIMEOUT 300)
add_dependencies(output_test programs)
cell_add_test(system/camera_command_test.cc
  LINK cell_bus cell_imaging TIMEOUT 900)
add_dependencies(camera_command_test programs)
cell_add_test(system/execution_command_test.cc LINK cell_bus TIMEOUT 900)
add_dependencies(execution_command_test programs)
cell_add_test(system/from_nothing_command_test.cc TIMEOUT 600)
add_dependencies(from_nothing_command_test programs)
cell_add_test(system/log_command_test.cc LINK cell_bus TIMEOUT 300)
cell_add_test(system/recording_test.cc LINK cell_cli cell_sec_builder TIMEOUT 300)
add_dependencies(recording_test programs)
cell_add_test(system/follow_test.cc LINK cell_bus TIMEOUT 300)
add_dependencies(follow_test programs)
add_dependencies(log_command_test programs)
cell_add_test(system/resumed_command_test.cc TIMEOUT 120)
add_dependencies(resumed_command_test programs)
cell_add_test(system/bad_input_test.cc TIMEOUT 120)
add_dependencies(bad_input_test programs)
cell_add_test(system/doctor_test.cc LINK cell_bus)
add_dependencies(doctor_test programs)
# What only a build with Java has (deploy/spy).
if(TARGET spy_jar)
  set(probe_dir ${CMAKE_CURRENT_BINARY_DIR}/spy)
  set(probe_java ${CMAKE_CURRENT_SOURCE_DIR}/system/spy/SpyProbe.java)
  add_custom_command(OUTPUT ${probe_dir}/probe.jar
    DEPENDS ${probe_java}
    COMMAND ${JAVAC} --release 17 -d ${probe_dir}/classes ${probe_java}
    COMMAND ${CMAKE_COMMAND} -E echo "Premain-Class: SpyProbe" > ${probe_dir}/manifest
    COMMAND ${JAR} --create --file ${probe_dir}/probe.jar
      --manifest ${probe_dir}/manifest -C ${probe_dir}/classes .)
  add_custom_target(spy_probe DEPENDS ${probe_dir}/probe.jar)
  cell_add_test(system/stock_tools_test.cc LINK cell_bus lodepng::lodepng TIMEOUT 300)
  target_compile_definitions(stock_tools_test PRIVATE
    CELL_SPY_PROBE="${probe_dir}/probe.jar"
    CELL_PICTURES_DIR="${CMAKE_BINARY_DIR}/pictures")
  add_dependencies(stock_tools_test programs spy_jar spy_probe)
endif()
cell_add_test(system/library_kill_test.cc LINK cell_library TIMEOUT 300)
cell_add_test(system/library_death_test.cc
  LINK cell_cli cell_library cell_recorder cell_tracker Threads::Threads
  TIMEOUT 600)
add_dependencies(library_death_test library)
cell_add_test(system/library_command_test.cc
  LINK cell_library cell_tracker TIMEOUT 300)
add_dependencies(library_command_test programs)
cell_add_test(system/systemd_test.cc LINK cell_bus TIMEOUT 600)
target_compile_definitions(systemd_test PRIVATE CELL_BUILD_DIR="${CMAKE_BINARY_DIR}")
add_dependencies(systemd_test programs)
cell_add_test(system/live_cell_test.cc LINK cell_cli Threads::Threads TIMEOUT 300)
add_dependencies(live_cell_test programs)
cell_add_test(system/demo_network_test.cc LINK cell_cli TIMEOUT 300)
add_dependencies(demo_network_test programs)
cell_add_test(system/hosts_test.cc LINK cell_cli cell_imaging TIMEOUT 300)
add_dependencies(hosts_test programs)
cell_add_test(system/terminal_test.cc LINK cell_bus Threads::Threads)
add_dependencies(terminal_test programs)
cell_add_test(system/mistakes_command_test.cc TIMEOUT 120)
add_dependencies(mistakes_command_test programs)
