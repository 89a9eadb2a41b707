cell_add_test(unit/project/purity_test.cc LINK fmt::fmt)
cell_add_test(unit/project/definitions_test.cc)
cell_add_test(unit/project/class_size_test.cc)
