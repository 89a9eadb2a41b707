cell_add_test(unit/printable_test.cc LINK cell_text)
