cell_add_test(unit/camera_set/camera_set_test.cc LINK cell_camera_set cell_tracker)
cell_add_test(unit/camera_set/recorded_frames_test.cc LINK cell_camera_set)
