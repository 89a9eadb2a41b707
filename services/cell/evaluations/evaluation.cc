#include "services/cell/evaluations/evaluation.h"

#include <algorithm>

#include "services/cell/evaluations/alarms_evaluation.h"
#include "services/cell/evaluations/assembly_evaluation.h"
#include "services/cell/evaluations/disturbed_evaluation.h"
#include "services/cell/evaluations/from_nothing_evaluation.h"
#include "services/cell/evaluations/goals_evaluation.h"
#include "services/cell/evaluations/insertion_evaluation.h"
#include "services/cell/evaluations/keyframes_evaluation.h"
#include "services/cell/evaluations/one_showing_evaluation.h"
#include "services/cell/evaluations/stops_evaluation.h"
#include "services/cell/evaluations/substitution_evaluation.h"
#include "services/cell/evaluations/sufficient_evaluation.h"
#include "services/cell/evaluations/variants_evaluation.h"
#include "services/cell/evaluations/watch_evaluation.h"

namespace cell::cli {

std::string Measure::verdict() const {
  if (!is_met()) return "NOT MET";
  if (interval().low >= goal) return "met";
  return num_good == num_all ? "no failure, but few trials"
                             : "met, but few trials";
}

std::vector<Trial> Evaluation::Trials(int runs, uint64_t seed,
                                      const std::string& group) const {
  std::vector<Trial> trials;
  for (const TrialGroup& g : groups()) {
    if (!group.empty() && g.name != group) continue;
    const double share = group.empty() ? g.share : 1;
    const int num = std::max(g.least, static_cast<int>(runs * share + 0.5));
    for (int i = 0; i < num; ++i) {
      trials.push_back({g.name, seed + static_cast<uint64_t>(i)});
    }
  }
  return trials;
}

std::vector<std::unique_ptr<Evaluation>> AllEvaluations() {
  std::vector<std::unique_ptr<Evaluation>> all;
  all.push_back(MakeWatchEvaluation());
  all.push_back(MakeAlarmsEvaluation());
  all.push_back(MakeAssemblyEvaluation());
  all.push_back(MakeDisturbedEvaluation());
  all.push_back(MakeStopsEvaluation());
  all.push_back(MakeGoalsEvaluation());
  all.push_back(MakeVariantsEvaluation());
  all.push_back(MakeFromNothingEvaluation());
  all.push_back(MakeInsertionEvaluation());
  all.push_back(MakeKeyframesEvaluation());
  all.push_back(MakeSubstitutionEvaluation());
  all.push_back(MakeOneShowingEvaluation());
  all.push_back(MakeSufficientEvaluation());
  return all;
}

}  // namespace cell::cli
