#include "services/cell/scoring/contact_score.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace cell::cli {
namespace {

using Events = std::vector<ContactEvent>;
using PairEvent = std::pair<ObjectPair, bool>;

PairEvent PairEventOf(const ContactEvent& event) {
  return {event.pair, event.is_touch};
}

std::map<PairEvent, std::vector<int64_t>> TimesOf(const Events& events) {
  std::map<PairEvent, std::vector<int64_t>> times;
  for (const ContactEvent& event : events) {
    times[PairEventOf(event)].push_back(event.utime);
  }
  return times;
}

/// The most pairs of times that are within the tolerance, both in order.
int NumMatched(const std::vector<int64_t>& truth,
               const std::vector<int64_t>& found, int64_t tolerance_us) {
  int num_matched = 0;
  auto next = found.begin();
  for (const int64_t utime : truth) {
    while (next != found.end() && *next < utime - tolerance_us) ++next;
    if (next == found.end() || *next > utime + tolerance_us) continue;
    ++num_matched;
    ++next;
  }
  return num_matched;
}

int NumMatched(const Events& truth, const Events& found, int64_t tolerance_us) {
  const auto times = TimesOf(found);
  int num_matched = 0;
  for (const auto& [kind, utimes] : TimesOf(truth)) {
    const auto it = times.find(kind);
    if (it == times.end()) continue;
    num_matched += NumMatched(utimes, it->second, tolerance_us);
  }
  return num_matched;
}

/// A hand takes a part, and lets it go.
struct Grip {
  std::string part;
  int64_t begin = 0, end = 0;
};

std::vector<Grip> GripsOf(const Events& truth, const SceneObjects& objects) {
  std::vector<Grip> grips;
  for (auto taken = truth.begin(); taken != truth.end(); ++taken) {
    const auto& [a, b] = taken->pair;
    const bool is_grip = (objects.IsHand(a) && objects.IsPart(b)) ||
                         (objects.IsHand(b) && objects.IsPart(a));
    if (!taken->is_touch || !is_grip) continue;
    const auto let_go = std::find_if(taken, truth.end(), [&](const auto& e) {
      return e.pair == taken->pair && !e.is_touch;
    });
    if (let_go == truth.end()) continue;
    grips.push_back({objects.IsPart(a) ? a : b, taken->utime, let_go->utime});
  }
  return grips;
}

/// Those of the part while it is held, and shortly before and after.
Events EventsOf(const Grip& grip, const Events& all, int64_t margin_us) {
  Events events;
  std::ranges::copy_if(all, std::back_inserter(events),
                       [&](const ContactEvent& event) {
                         const auto& [a, b] = event.pair;
                         return (a == grip.part || b == grip.part) &&
                                event.utime >= grip.begin - margin_us &&
                                event.utime <= grip.end + margin_us;
                       });
  return events;
}

bool IsExact(const Events& truth, const Events& found, int64_t tolerance_us) {
  const auto of_found = TimesOf(found), of_truth = TimesOf(truth);
  const auto has_same_number = [](const auto& a, const auto& b) {
    return a.first == b.first && a.second.size() == b.second.size();
  };
  if (!std::ranges::equal(of_truth, of_found, has_same_number)) return false;
  std::map<PairEvent, size_t> num_before;
  std::vector<std::pair<int64_t, int64_t>> times;  // true, found
  for (const ContactEvent& event : truth) {
    const auto& found_times = of_found.at(PairEventOf(event));
    times.emplace_back(event.utime,
                       found_times[num_before[PairEventOf(event)]++]);
  }
  for (const auto& [true_a, found_a] : times) {
    for (const auto& [true_b, found_b] : times) {
      if (true_b - true_a > tolerance_us && found_b <= found_a) return false;
    }
  }
  return true;
}

using Columns = std::vector<std::set<PairEvent>>;

/// Changes within `merge_us` of the first of a column are in it.
Columns ColumnsOf(const Events& events, int64_t merge_us) {
  Columns columns;
  std::optional<int64_t> first;
  for (const ContactEvent& event : events) {
    if (!first || event.utime - *first > merge_us) {
      columns.emplace_back();
      first = event.utime;
    }
    columns.back().insert(PairEventOf(event));
  }
  return columns;
}

/// All events with the time of their column's first one.
Events WithColumnTimes(Events events, int64_t merge_us) {
  std::optional<int64_t> first;
  for (ContactEvent& event : events) {
    if (!first || event.utime - *first > merge_us) first = event.utime;
    event.utime = *first;
  }
  return events;
}

}  // namespace

ContactScore& ContactScore::operator+=(const ContactScore& other) {
  num_true += other.num_true;
  num_found += other.num_found;
  num_matched += other.num_matched;
  num_actions += other.num_actions;
  num_exact += other.num_exact;
  num_same_columns += other.num_same_columns;
  return *this;
}

ContactScore ScoreContacts(const std::vector<ContactEvent>& truth,
                           const std::vector<ContactEvent>& found,
                           const SceneObjects& scene_objects,
                           const ContactScoreParams& params) {
  ContactScore score;
  score.num_true = static_cast<int>(truth.size());
  score.num_found = static_cast<int>(found.size());
  score.num_matched = NumMatched(truth, found, params.tolerance_us);
  const Events merged = WithColumnTimes(truth, params.merge_us);
  for (const Grip& grip : GripsOf(truth, scene_objects)) {
    const auto of = [&](const Events& all) {
      return EventsOf(grip, all, params.tolerance_us);
    };
    ++score.num_actions;
    score.num_exact += IsExact(of(truth), of(found), params.tolerance_us);
    score.num_same_columns +=
        ColumnsOf(of(merged), 0) == ColumnsOf(of(found), 0);
  }
  return score;
}

}  // namespace cell::cli
