#include "services/planner/arm_states.h"

#include <algorithm>
#include <set>
#include <utility>

namespace cell::planner {
namespace {

constexpr auto kHeld = Predicate::Report::kHeld;

Truth FromBool(bool value) {
  return value ? Truth::kTrue : Truth::kFalse;
}

/// Calls visit(atom, report, objects) for every atom that arms report.
template <class Visit>
void ForEachReported(const Vocabulary& vocabulary, Visit visit) {
  for (int index = 0; index < vocabulary.num_atoms(); ++index) {
    const GroundAtom atom = vocabulary.Atom(index);
    const auto& report = vocabulary.predicates()[atom.predicate].report;
    if (report) visit(index, *report, atom.objects);
  }
}

}  // namespace

ArmStates::ArmStates(std::shared_ptr<const Vocabulary> vocabulary)
    : vocabulary_(std::move(vocabulary)) {
  std::set<int> arms;
  for (const Predicate& predicate : vocabulary_->predicates()) {
    if (!predicate.report) continue;
    const size_t place = predicate.report == kHeld ? 1 : 0;
    for (const int arm :
         vocabulary_->ObjectsOf(predicate.argument_types[place])) {
      arms.insert(arm);
    }
  }
  arms_.assign(arms.begin(), arms.end());
}

void ArmStates::Update(const ArmState& report) {
  const auto [it, is_new] = reports_.try_emplace(report.arm, report);
  if (!is_new && report.utime >= it->second.utime) it->second = report;
}

const ArmState* ArmStates::Of(int arm) const {
  const auto it = reports_.find(arm);
  return it == reports_.end() ? nullptr : &it->second;
}

const SkillTraits* ArmStates::TraitsOf(int arm,
                                       const std::string& skill) const {
  const ArmState* report = Of(arm);
  if (report == nullptr) return nullptr;
  const auto it = report->skills.find(skill);
  return it == report->skills.end() ? nullptr : &it->second;
}

bool ArmStates::HaveReportedSince(int64_t utime) const {
  return std::all_of(arms_.begin(), arms_.end(), [&](int arm) {
    const ArmState* report = Of(arm);
    return report != nullptr && report->utime >= utime;
  });
}

bool ArmStates::AreIdle() const {
  return std::all_of(arms_.begin(), arms_.end(), [&](int arm) {
    const ArmState* report = Of(arm);
    return report != nullptr && report->request == ArmState::kIdle;
  });
}

State ArmStates::WithReports(State state) const {
  ForEachReported(*vocabulary_, [&](int atom, Predicate::Report report,
                                    const std::vector<int>& objects) {
    state.Set(atom, report == kHeld ? IsHeld(objects[0], objects[1])
                                    : IsReachable(objects[0], objects[1]));
  });
  return state;
}

Truth ArmStates::IsHeld(int part, int arm) const {
  const ArmState* report = Of(arm);
  return report == nullptr ? Truth::kUnknown : FromBool(report->held == part);
}

Truth ArmStates::IsReachable(int arm, int part) const {
  for (const int other : arms_) {
    const ArmState* report = Of(other);
    if (report != nullptr && report->held == part)
      return FromBool(other == arm);
  }
  const ArmState* report = Of(arm);
  if (report == nullptr) return Truth::kUnknown;
  const auto& parts = report->reachable;
  return FromBool(std::find(parts.begin(), parts.end(), part) != parts.end());
}

State WithoutArms(State state, const Vocabulary& vocabulary) {
  ForEachReported(vocabulary,
                  [&](int atom, Predicate::Report, const std::vector<int>&) {
                    state.Set(atom, Truth::kFalse);
                  });
  return state;
}

}  // namespace cell::planner
