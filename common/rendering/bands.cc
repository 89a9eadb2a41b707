#include "common/rendering/bands.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace cell {

void ForEachBand(int num_rows, int band, int num_threads,
                 const std::function<void(int first, int last)>& work) {
  std::atomic<int> next = 0;  // the first row not taken yet
  const auto take_bands = [&] {
    for (int first = next.fetch_add(band); first < num_rows;
         first = next.fetch_add(band)) {
      work(first, std::min(first + band, num_rows));
    }
  };
  if (num_threads == 0) {
    num_threads = static_cast<int>(std::thread::hardware_concurrency());
  }
  std::vector<std::jthread> helpers;
  for (int i = 1; i < num_threads; ++i) helpers.emplace_back(take_bands);
  take_bands();
}

}  // namespace cell
