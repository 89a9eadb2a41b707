cell_add_test(unit/text/printable_test.cc LINK cell_text)
cell_add_test(unit/text/nearest_test.cc LINK cell_text)
