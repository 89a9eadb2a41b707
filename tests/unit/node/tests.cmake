cell_add_test(unit/node/number_option_test.cc LINK cell_node CLI11::CLI11)
