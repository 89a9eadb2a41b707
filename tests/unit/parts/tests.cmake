cell_add_test(unit/parts/part_table_test.cc LINK cell_layout cell_parts)
