#include "common/sec/role_similarity.h"

#include <algorithm>
#include <functional>

#include "common/relational/state.h"
#include "common/sec/role_matching.h"
#include "common/sec/stand_ins.h"

namespace cell {
namespace {

constexpr double kLiteralShare = 0.7;

/// With the moved part as role 0.
LearnedModel MovedFirst(const LearnedModel& model) {
  RoleMap places;
  size_t next = 1;
  for (size_t i = 0; i < model.roles.size(); ++i) {
    places.push_back(i == model.moved ? 0 : next++);
  }
  LearnedModel moved_first = model;
  moved_first.moved = 0;
  moved_first.pick = Renamed(model.pick, places);
  moved_first.place = Renamed(model.place, places);
  for (size_t i = 0; i < places.size(); ++i) {
    moved_first.roles[*places[i]] = model.roles[i];
  }
  for (Contribution& contribution : moved_first.taught) {
    contribution = Renamed(contribution, places);
  }
  return moved_first;
}

/// Jaccard index; @pre one of them has something.
double OverlapOf(const LiteralSet& a, const LiteralSet& b, size_t num_more) {
  const auto num_common = static_cast<size_t>(std::ranges::count_if(
      a, [&](const Literal& l) { return b.contains(l); }));
  return static_cast<double>(num_common) /
         static_cast<double>(a.size() + b.size() + num_more - num_common);
}

/// True if objects of the other roles can be found so that all static
/// relations hold.
bool FitsSomething(const LearnedModel& model, int object,
                   const Vocabulary& vocabulary) {
  const State nothing(vocabulary.num_atoms());
  const auto fits = [&](const Binding& binding) {
    return std::ranges::all_of(model.pick.where, [&](const Literal& literal) {
      return !literal.is_static ||
             MustHold(literal, binding, nothing, vocabulary);
    });
  };
  const std::function<bool(Binding)> extend = [&](Binding binding) {
    if (binding.size() == model.roles.size()) return fits(binding);
    return std::ranges::any_of(
        vocabulary.ObjectsOf(model.roles[binding.size()].type),
        [&](const int other) {
          if (std::ranges::find(binding, other) != binding.end()) return false;
          Binding longer = binding;
          longer.push_back(other);
          return extend(std::move(longer));
        });
  };
  return extend({object});
}

}  // namespace

RoleSimilarity::RoleSimilarity(const Models& models, const SceneWords& words,
                               const ChainSimilarity& chains)
    : words_(words), chains_(chains) {
  for (const auto& [name, model] : models) {
    names_.push_back(name);
    models_.push_back(MovedFirst(model));
  }
  const TypeHierarchy& types = words.vocabulary.types();
  for (size_t m = 0; m < models_.size(); ++m) {
    const auto put = [&](size_t role, int type) {
      for (const int object : words.vocabulary.ObjectsOf(type)) {
        const int own =
            words.vocabulary.objects()[static_cast<size_t>(object)].type;
        auto& players = players_[types.name(own)];
        const Player player{m, role};
        if (std::ranges::find(players, player) == players.end()) {
          players.push_back(player);
        }
      }
    };
    for (size_t role = 0; role < models_[m].roles.size(); ++role) {
      for (const Contribution& contribution : models_[m].taught) {
        put(role, contribution.types[role]);
      }
      if (models_[m].taught.empty()) put(role, models_[m].roles[role].type);
    }
  }
}

double RoleSimilarity::Between(size_t a, size_t b,
                               const std::pair<size_t, size_t>* roles) const {
  const bool is_swapped = models_[a].roles.size() < models_[b].roles.size();
  const LearnedModel& more = models_[is_swapped ? b : a];
  const LearnedModel& fewer = models_[is_swapped ? a : b];
  const LiteralSet of_more = more.RequiredLiterals();
  const LiteralSet of_fewer = fewer.RequiredLiterals();
  const double chains = chains_.Between(more.chain, fewer.chain);
  double best = 0;
  ForEachMatching(
      more.roles.size(), fewer.roles.size(), [&](const RoleMap& places) {
        if (roles != nullptr) {
          const auto [in_a, in_b] = *roles;
          if (places[is_swapped ? in_b : in_a] != (is_swapped ? in_a : in_b)) {
            return;
          }
        }
        double similarity = chains;
        if (!of_more.empty() || !of_fewer.empty()) {
          const LiteralSet renamed = Renamed(of_more, places);
          similarity =
              kLiteralShare * OverlapOf(of_fewer, renamed,
                                        of_more.size() - renamed.size()) +
              (1 - kLiteralShare) * chains;
        }
        best = std::max(best, similarity);
      });
  return best;
}

std::vector<std::vector<double>> RoleSimilarity::OfActions() const {
  std::vector<std::vector<double>> similarities(names_.size());
  for (size_t a = 0; a < names_.size(); ++a) {
    for (size_t b = 0; b < names_.size(); ++b) {
      similarities[a].push_back(Between(a, b, nullptr));
    }
  }
  return similarities;
}

std::vector<std::string> RoleSimilarity::Types() const {
  std::vector<std::string> types;
  for (const auto& [type, players] : players_) types.push_back(type);
  return types;
}

std::vector<std::vector<double>> RoleSimilarity::OfTypes() const {
  std::vector<std::vector<double>> similarities;
  for (const auto& [type, players] : players_) {
    auto& row = similarities.emplace_back();
    for (const auto& [other, others] : players_) {
      double best = 0;
      for (const Player& player : players) {
        for (const Player& p : others) {
          const std::pair roles(player.role, p.role);
          best = std::max(best, Between(player.model, p.model, &roles));
        }
      }
      row.push_back(best);
    }
  }
  return similarities;
}

std::vector<RoleSimilarity::StandIn> RoleSimilarity::AllStandIns() const {
  std::vector<StandIn> stand_ins;
  for (size_t m = 0; m < models_.size(); ++m) {
    for (const int object : StandIns(models_[m], models_, words_.vocabulary)) {
      if (!FitsSomething(models_[m], object, words_.vocabulary)) continue;
      stand_ins.push_back(
          {words_.vocabulary.objects()[static_cast<size_t>(object)].name,
           names_[m]});
    }
  }
  return stand_ins;
}

std::vector<std::vector<size_t>> GroupsOf(
    const std::vector<std::vector<double>>& similarities, double threshold) {
  std::vector<std::vector<size_t>> groups;
  std::vector<bool> is_grouped(similarities.size(), false);
  for (size_t first = 0; first < similarities.size(); ++first) {
    if (is_grouped[first]) continue;
    std::vector<size_t> group = {first};
    is_grouped[first] = true;
    for (size_t i = 0; i < group.size(); ++i) {
      for (size_t other = 0; other < similarities.size(); ++other) {
        if (is_grouped[other] || similarities[group[i]][other] < threshold) {
          continue;
        }
        is_grouped[other] = true;
        group.push_back(other);
      }
    }
    std::ranges::sort(group);
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace cell
