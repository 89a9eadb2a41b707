cell_add_test(unit/rexd/dead_end_memory_test.cc LINK cell_rexd)
cell_add_test(unit/rexd/rexd_test.cc LINK cell_rexd)
cell_add_test(unit/rexd/rule_model_test.cc LINK cell_rexd)
cell_add_test(unit/rexd/guidance_test.cc LINK cell_rexd)
