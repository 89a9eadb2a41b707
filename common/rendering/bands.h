#pragma once

#include <functional>

namespace cell {

/// Calls work(first, last) for bands of at most `band` rows, first <= row <
/// last, that make up [0, num_rows): each once, in any order, at the same time
/// on `num_threads` threads, the caller's among them; 0: as many as the machine
/// has cores. Work must not throw.
void ForEachBand(int num_rows, int band, int num_threads,
                 const std::function<void(int first, int last)>& work);

}  // namespace cell
