#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "common/sec/role_similarity.h"

namespace cell {

/// What taught a library, and how alike it is (section VI-A): the similarity
/// matrix of all members of its models. It follows from the members alone, so
/// that it is computed when it is asked for and never stored: an action that is
/// renamed, merged or taken back in part leaves nothing behind that disagrees.
struct LibraryMembers {
  std::vector<std::string> names;  ///< "assembly 1", the demonstrations
  std::vector<size_t> model_of;    ///< in the order of the models, ascending
  /// By RoleSimilarity, row by row, from 0 to 1; it does not look at types.
  std::vector<std::vector<double>> similarities;

  /// Those between the members of one model.
  std::vector<std::vector<double>> OfModel(size_t model) const;
};

LibraryMembers CompareMembers(const RoleSimilarity::Models& models,
                              const SceneWords& words,
                              const ChainSimilarity& chains);

/// The histogram of the similarities of all pairs of members, and where Otsu's
/// method divides it.
struct MemberHistogram {
  static constexpr size_t kNumBins = 20;  ///< between 0 and 1
  std::array<size_t, kNumBins> of_one{};  ///< pairs of members of one model
  std::array<size_t, kNumBins> of_two{};  ///< pairs of two models
  double cut = 0;                         ///< OtsuCut() of all
  double tau = 0;  ///< of section VI-A: the mean of those from the cut on
  /// Pairs of models some of whose members are as similar as `cut`: only types
  /// tell these apart. Ascending.
  std::vector<std::pair<size_t, size_t>> alike;

  size_t num_pairs() const;
};

MemberHistogram HistogramOf(const LibraryMembers& members);

}  // namespace cell
