# Benchmarks are built with the rest and run by scripts/bench, never by ctest.
add_executable(bus_bench bench/bus_bench.cc)
target_include_directories(bus_bench PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(bus_bench PRIVATE
  cell_bus benchmark::benchmark Threads::Threads cell_warnings)
add_executable(whole_cell_bench
  bench/whole_cell_bench.cc bench/measured_cell.cc)
target_include_directories(whole_cell_bench PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(whole_cell_bench PRIVATE
    cell_cli mujoco::mujoco fmt::fmt cell_warnings)
add_executable(watching_bench bench/watching_bench.cc)
target_include_directories(watching_bench PRIVATE ${PROJECT_SOURCE_DIR})
target_compile_definitions(watching_bench PRIVATE
  CELL_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_link_libraries(watching_bench PRIVATE cell_tracker cell_sec_builder
  cell_recognizer benchmark::benchmark cell_warnings)
add_executable(sec_bench bench/sec_bench.cc)
target_include_directories(sec_bench PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(sec_bench PRIVATE cell_sec_builder fmt::fmt
  benchmark::benchmark cell_warnings)
add_executable(arm_loop_bench bench/arm_loop_bench.cc)
target_include_directories(arm_loop_bench PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(arm_loop_bench PRIVATE cell_cli fmt::fmt Threads::Threads
  cell_warnings)
add_executable(arms_bench bench/arms_bench.cc)
target_include_directories(arms_bench PRIVATE ${PROJECT_SOURCE_DIR})
target_compile_definitions(arms_bench PRIVATE
  CELL_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_link_libraries(arms_bench PRIVATE cell_arms cell_tracker
  benchmark::benchmark cell_warnings)
add_executable(imaging_bench bench/imaging_bench.cc)
target_include_directories(imaging_bench PRIVATE ${PROJECT_SOURCE_DIR})
target_compile_definitions(imaging_bench PRIVATE
  CELL_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_link_libraries(imaging_bench PRIVATE cell_cli cell_camera_set embree
  lodepng::lodepng benchmark::benchmark cell_warnings)
add_executable(chain_bench bench/chain_bench.cc)
target_include_directories(chain_bench PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(chain_bench PRIVATE
  cell_sec benchmark::benchmark cell_warnings)
add_executable(planning_bench bench/planning_bench.cc)
target_include_directories(planning_bench PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(planning_bench PRIVATE cell_planning benchmark::benchmark
  cell_warnings)
add_executable(rules_bench bench/rules_bench.cc)
target_include_directories(rules_bench PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(rules_bench PRIVATE cell_rules benchmark::benchmark
  cell_warnings)
# What scripts/bench makes of their figures.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME bench_report_test
  COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/bench/report_test.py)
set_tests_properties(bench_report_test PROPERTIES LABELS unit TIMEOUT 60)
add_executable(deciding_bench bench/deciding_bench.cc)
target_include_directories(deciding_bench PRIVATE ${PROJECT_SOURCE_DIR})
target_compile_definitions(deciding_bench PRIVATE
  CELL_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_link_libraries(deciding_bench PRIVATE cell_planner cell_task fmt::fmt
  cell_warnings)
