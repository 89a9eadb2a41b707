cell_add_test(unit/sec_builder/pair_filter_test.cc LINK cell_sec_builder)
cell_add_test(unit/sec_builder/key_frame_extractor_test.cc LINK cell_sec_builder)
cell_add_test(unit/sec_builder/proximity_test.cc LINK cell_sec_builder cell_tracker)
cell_add_test(unit/sec_builder/pose_smoother_test.cc LINK cell_sec_builder)
