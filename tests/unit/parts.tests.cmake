cell_add_test(unit/part_table_test.cc LINK cell_layout cell_parts)
