cell_add_test(unit/config/config_test.cc LINK cell_config fmt::fmt)
cell_add_test(unit/config/unit_reasons_test.cc LINK cell_cli)
