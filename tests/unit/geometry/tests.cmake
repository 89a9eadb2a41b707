cell_add_test(unit/geometry/pose_test.cc LINK cell_geometry)
cell_add_test(unit/geometry/part_shape_test.cc LINK cell_geometry)
