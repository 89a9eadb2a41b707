cell_add_test(unit/config/config_test.cc LINK cell_config fmt::fmt)
