#include "common/sec/library_members.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "common/sec/similarity_cut.h"
#include "common/text/counted.h"

namespace cell {
namespace {

/// What one demonstration has taught of a model, as a model of its own.
LearnedModel ModelOf(const Contribution& contribution,
                     const LearnedModel& model) {
  LearnedModel own = model;
  for (size_t role = 0; role < own.roles.size(); ++role) {
    own.roles[role].type = contribution.types[role];
  }
  own.pick = contribution.pick;
  own.place = contribution.place;
  own.chain = contribution.chain;
  own.shown = contribution.shown;
  own.taught = {contribution};
  return own;
}

/// "assembly 1" or, of several demonstrations, "assembly 1 and 2 others".
std::string NameOf(const Contribution& contribution) {
  const auto& shown = contribution.shown;
  if (shown.empty()) return "?";
  if (shown.size() == 1) return shown.begin()->first;
  return fmt::format("{} and {}", shown.begin()->first,
                     Counted(static_cast<int64_t>(shown.size()) - 1, "other"));
}

}  // namespace

std::vector<std::vector<double>> LibraryMembers::OfModel(size_t model) const {
  const auto [begin, end] = std::ranges::equal_range(model_of, model);
  const auto first = begin - model_of.begin(), last = end - model_of.begin();
  std::vector<std::vector<double>> block;
  for (auto i = first; i < last; ++i) {
    const auto& row = similarities[static_cast<size_t>(i)];
    block.emplace_back(row.begin() + first, row.begin() + last);
  }
  return block;
}

LibraryMembers CompareMembers(const RoleSimilarity::Models& models,
                              const SceneWords& words,
                              const ChainSimilarity& chains) {
  LibraryMembers members;
  RoleSimilarity::Models alone;
  size_t number = 0;
  for (const auto& [name, model] : models) {
    for (const Contribution& contribution : model.taught) {
      // In the order of the members.
      alone.emplace(fmt::format("{:08}", members.names.size()),
                    ModelOf(contribution, model));
      members.names.push_back(NameOf(contribution));
      members.model_of.push_back(number);
    }
    ++number;
  }
  members.similarities = RoleSimilarity(alone, words, chains).OfActions();
  return members;
}

size_t MemberHistogram::num_pairs() const {
  return std::accumulate(of_one.begin(), of_one.end(), size_t{0}) +
         std::accumulate(of_two.begin(), of_two.end(), size_t{0});
}

MemberHistogram HistogramOf(const LibraryMembers& members) {
  MemberHistogram histogram;
  std::vector<double> all;
  const auto for_each_pair = [&](const auto& visit) {
    for (size_t i = 0; i < members.names.size(); ++i) {
      for (size_t j = i + 1; j < members.names.size(); ++j) {
        visit(members.model_of[i], members.model_of[j],
              members.similarities[i][j]);
      }
    }
  };
  for_each_pair([&](size_t a, size_t b, double similarity) {
    const auto bin = static_cast<size_t>(similarity * histogram.kNumBins);
    ++(a == b ? histogram.of_one
              : histogram.of_two)[std::min(bin, histogram.kNumBins - 1)];
    all.push_back(similarity);
  });
  histogram.cut = OtsuCut(all);
  histogram.tau = MeanFrom(histogram.cut, all);
  std::set<std::pair<size_t, size_t>> alike;
  for_each_pair([&](size_t a, size_t b, double similarity) {
    if (a != b && similarity >= histogram.cut) alike.emplace(a, b);
  });
  histogram.alike.assign(alike.begin(), alike.end());
  return histogram;
}

}  // namespace cell
