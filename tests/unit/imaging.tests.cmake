cell_add_test(unit/imaging_test.cc LINK cell_imaging zstd::zstd)
