cell_add_test(unit/recordings/recording_text_test.cc LINK cell_recordings cell_geometry)
cell_add_test(unit/recordings/noisy_tracks_test.cc LINK cell_recordings cell_geometry)
