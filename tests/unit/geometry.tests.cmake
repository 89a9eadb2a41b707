cell_add_test(unit/pose_test.cc LINK cell_geometry)
cell_add_test(unit/part_shape_test.cc LINK cell_geometry)
