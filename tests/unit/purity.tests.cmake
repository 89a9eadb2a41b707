cell_add_test(unit/purity_test.cc LINK fmt::fmt)
