cell_add_test(unit/rendering_test.cc LINK cell_rendering)
