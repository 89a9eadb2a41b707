#include "common/sec/learned_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace cell {
namespace {

std::string Signature(std::span<const Variable> variables,
                      const TypeHierarchy& types) {
  std::string text;
  for (const Variable& variable : variables) {
    text += (text.empty() ? "" : ", ") + types.name(variable.type);
  }
  return "(" + text + ")";
}

}  // namespace

Contribution Renamed(const Contribution& contribution, const RoleMap& places) {
  Contribution renamed = contribution;
  renamed.pick = Renamed(contribution.pick, places);
  renamed.place = Renamed(contribution.place, places);
  for (size_t i = 0; i < places.size(); ++i) {
    renamed.types.at(places[i].value()) = contribution.types.at(i);
  }
  return renamed;
}

int LearnedModel::NumShown() const {
  return std::accumulate(
      shown.begin(), shown.end(), 0,
      [](int sum, const auto& entry) { return sum + entry.second; });
}

LiteralSet LearnedModel::RequiredLiterals() const {
  LiteralSet required = ChangedLiterals(pick, place);
  std::erase_if(required, [this](const Literal& literal) {
    return !Mentions(literal, moved);
  });
  return required;
}

bool LearnedModel::SaysTheSame(const LearnedModel& other) const {
  LearnedModel copy = other;
  copy.shown = shown;
  copy.taught = taught;
  return *this == copy;
}

int CommonType(const TypeHierarchy& types, int a, int b) {
  int common = TypeHierarchy::kObject;
  for (int type = 0; type < types.size(); ++type) {
    if (types.IsA(a, type) && types.IsA(b, type) && types.IsA(type, common)) {
      common = type;
    }
  }
  return common;
}

Result<std::vector<size_t>> ArgumentsOf(std::span<const Variable> roles,
                                        std::span<const Variable> arguments,
                                        const TypeHierarchy& types) {
  std::vector<size_t> order(roles.size());
  std::iota(order.begin(), order.end(), size_t{0});
  const auto fits = [&] {
    for (size_t i = 0; i < order.size(); ++i) {
      if (!types.IsA(roles[i].type, arguments[order[i]].type)) return false;
    }
    return true;
  };
  if (arguments.size() == roles.size()) {
    do {
      if (fits()) return order;
    } while (std::next_permutation(order.begin(), order.end()));
  }
  return Reason{fmt::format("it was shown with {}, but takes {}",
                            Signature(roles, types),
                            Signature(arguments, types))};
}

Result<LearnedModel> FitToArguments(const LearnedModel& model,
                                    std::span<const Variable> arguments,
                                    const TypeHierarchy& types) {
  const auto order = ArgumentsOf(model.roles, arguments, types);
  if (!order) return Reason{order.reason()};
  const RoleMap places(order->begin(), order->end());
  LearnedModel fitted{{arguments.begin(), arguments.end()},
                      (*order)[model.moved],
                      Renamed(model.pick, places),
                      Renamed(model.place, places),
                      model.chain,
                      model.shown,
                      {}};
  for (const Contribution& contribution : model.taught) {
    fitted.taught.push_back(Renamed(contribution, places));
  }
  return fitted;
}

}  // namespace cell
