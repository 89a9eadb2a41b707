cell_add_test(unit/imaging/imaging_test.cc LINK cell_imaging zstd::zstd)
