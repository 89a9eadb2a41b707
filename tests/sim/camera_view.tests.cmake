cell_add_test(sim/camera_view_test.cc LINK cell_cli cell_rendering cell_tracker)
