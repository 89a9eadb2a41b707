#include "services/cell/evaluations/excuse_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <vector>

#include "common/planning/ground_model.h"
#include "common/planning/planner.h"

namespace cell::cli {

namespace {

constexpr int kMaxTriedChanges = 3;
constexpr int kMaxDraws = 100'000;

const std::string& PredicateOf(const planning::Literal& literal,
                               const ExcuseCase& excuse_case) {
  return excuse_case.task.atoms[static_cast<size_t>(literal.atom)].predicate;
}

bool IsOfMissing(const planning::Literal& literal,
                 const ExcuseCase& excuse_case) {
  return excuse_case.missing.contains(PredicateOf(literal, excuse_case));
}

bool HoldsMissing(const planning::Changes& changes,
                  const ExcuseCase& excuse_case) {
  return std::ranges::any_of(changes, [&](const planning::Literal& l) {
    return IsOfMissing(l, excuse_case);
  });
}

bool IsNamed(const ExcuseCase& excuse_case) {
  const auto is_named = [&](const planning::Literal& l) {
    return IsOfMissing(l, excuse_case) &&
           excuse_case.text.find(Show(l, excuse_case.task.atoms)) !=
               std::string::npos;
  };
  return std::ranges::any_of(excuse_case.excuses, [&](const auto& excuse) {
    return std::ranges::any_of(excuse, is_named);
  });
}

/// Plans in a ground task from changed states; keeps what it has found out.
class ChangedStatePlanner {
 public:
  explicit ChangedStatePlanner(const planning::GroundTask& task)
      : model_(std::make_shared<planning::GroundModel>(task)),
        planner_(model_, Params()) {}

  bool HasPlan(const planning::Changes& changes) {
    std::vector<bool> state = model_->task().initial;
    for (const planning::Literal& l : changes) {
      state[static_cast<size_t>(l.atom)] = l.value;
    }
    const auto plan = planner_.Find(model_->Pack(state));
    if (plan.status == planning::Plan::Status::kUndecided) {
      throw std::runtime_error("too large to decide: " + plan.reason);
    }
    return plan.status != planning::Plan::Status::kNoPlan;
  }

 private:
  static planning::Planner::Params Params() {
    planning::Planner::Params params;
    params.minimize_actions = false;
    return params;
  }

  std::shared_ptr<planning::GroundModel> model_;
  planning::Planner planner_;
};

std::string ShowAll(const ExcuseCase& excuse_case) {
  std::string text;
  for (const planning::Changes& excuse : excuse_case.excuses) {
    if (!text.empty()) text += " or ";
    for (const planning::Literal& l : excuse) {
      text += (l == excuse.front() ? "" : "; ") +
              planning::Show(l, excuse_case.task.atoms);
    }
  }
  return text;
}

}  // namespace

std::string ToText(Damage damage) {
  switch (damage) {
    case Damage::kRule:
      return "rule taken away";
    case Damage::kEffect:
      return "effect taken away";
    case Damage::kPrecondition:
      return "false precondition";
  }
  return "";
}

ExcuseVerdict Judge(const ExcuseCase& excuse_case) {
  ExcuseVerdict verdict;
  if (excuse_case.excuses.empty()) return verdict;
  verdict.size = static_cast<int>(excuse_case.excuses.front().size());
  ChangedStatePlanner planner(excuse_case.task);
  const auto has_plan = [&](const planning::Changes& changes) {
    return planner.HasPlan(changes);
  };
  verdict.is_minimal =
      std::ranges::all_of(excuse_case.excuses, [&](const auto& excuse) {
        return static_cast<int>(excuse.size()) == verdict.size;
      });
  const int last = std::min(verdict.size - 1, kMaxTriedChanges);
  for (int size = 0; size <= last && verdict.is_minimal; ++size) {
    verdict.is_minimal = !FindAmongAllChanges(excuse_case.task, size, has_plan,
                                              &verdict.num_tried);
  }
  const auto holds = [&](const planning::Changes& excuse) {
    return HoldsMissing(excuse, excuse_case);
  };
  verdict.has_missing = std::ranges::any_of(excuse_case.excuses, holds);
  verdict.is_first = holds(excuse_case.excuses.front());
  verdict.is_named = IsNamed(excuse_case);
  const auto would_do = [&](const planning::Changes& changes) {
    return HoldsMissing(changes, excuse_case) && planner.HasPlan(changes);
  };
  verdict.may_hold_missing =
      verdict.has_missing ||
      (verdict.size <= kMaxTriedChanges &&
       FindAmongAllChanges(excuse_case.task, verdict.size, would_do));
  return verdict;
}

nlohmann::json ExcuseRow(const DamagedDomain& domain, uint64_t seed) {
  rules::RandomNumbers seeds(seed);
  int num_with_plan = 0;
  int num_other = 0;
  for (int draw = 0; draw < kMaxDraws; ++draw) {
    const auto excuse_case = domain.Draw(seeds.Next());
    if (!excuse_case) {
      ++num_with_plan;
      continue;
    }
    const ExcuseVerdict verdict = Judge(*excuse_case);
    const bool is_other = verdict.size > 0 && verdict.is_minimal &&
                          excuse_case->helps && !verdict.may_hold_missing;
    if (is_other) {
      ++num_other;
      continue;
    }
    return {{"seed", seed},
            {"damage", ToText(excuse_case->damage)},
            {"what", excuse_case->what},
            {"excuses", ShowAll(*excuse_case)},
            {"text", excuse_case->text},
            {"size", verdict.size},
            {"minimal", verdict.is_minimal},
            {"holds", verdict.has_missing},
            {"first", verdict.is_first},
            {"named", verdict.is_named},
            {"helps", excuse_case->helps},
            {"tried", verdict.num_tried},
            {"with_plan", num_with_plan},
            {"other", num_other}};
  }
  throw std::runtime_error(fmt::format(
      "no state without a plan in {} draws; give a domain whose actions are "
      "needed",
      kMaxDraws));
}

}  // namespace cell::cli
