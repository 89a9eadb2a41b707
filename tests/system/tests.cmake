cell_add_test(system/lcm_lockstep_test.cc LINK cell_bus Threads::Threads)
