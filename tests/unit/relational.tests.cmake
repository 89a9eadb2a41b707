cell_add_test(unit/domain_test.cc LINK cell_relational)

