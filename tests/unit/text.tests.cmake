cell_add_test(unit/printable_test.cc LINK cell_text)
cell_add_test(unit/nearest_test.cc LINK cell_text)
