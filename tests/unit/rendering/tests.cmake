cell_add_test(unit/rendering/rendering_test.cc LINK cell_rendering)
cell_add_test(unit/rendering/framing_test.cc LINK cell_rendering Eigen3::Eigen)
