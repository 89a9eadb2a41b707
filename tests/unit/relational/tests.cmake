cell_add_test(unit/relational/domain_test.cc LINK cell_relational)
cell_add_test(unit/relational/rule_set_test.cc LINK cell_relational)
cell_add_test(unit/relational/request_words_test.cc LINK cell_relational)
cell_add_test(unit/relational/undoing_test.cc LINK cell_relational)
