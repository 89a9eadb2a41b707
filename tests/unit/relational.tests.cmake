cell_add_test(unit/domain_test.cc LINK cell_relational)
cell_add_test(unit/rule_set_test.cc LINK cell_relational)
cell_add_test(unit/request_words_test.cc LINK cell_relational)
