cell_add_test(unit/purity_test.cc LINK fmt::fmt)
cell_add_test(unit/definitions_test.cc)
