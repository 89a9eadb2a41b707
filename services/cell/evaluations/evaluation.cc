#include "services/cell/evaluations/evaluation.h"

#include "services/cell/evaluations/assembly_evaluation.h"
#include "services/cell/evaluations/disturbed_evaluation.h"
#include "services/cell/evaluations/from_nothing_evaluation.h"
#include "services/cell/evaluations/insertion_evaluation.h"
#include "services/cell/evaluations/keyframes_evaluation.h"
#include "services/cell/evaluations/one_showing_evaluation.h"
#include "services/cell/evaluations/stops_evaluation.h"
#include "services/cell/evaluations/substitution_evaluation.h"
#include "services/cell/evaluations/sufficient_evaluation.h"
#include "services/cell/evaluations/watch_evaluation.h"

namespace cell::cli {

std::string Measure::verdict() const {
  if (!is_met()) return "NOT MET";
  if (interval().low >= goal) return "met";
  return num_good == num_all ? "no failure, but few trials"
                             : "met, but few trials";
}

void AddTrials(const std::string& group, int num, uint64_t seed,
               std::vector<Trial>* trials) {
  for (int i = 0; i < num; ++i) {
    trials->push_back({group, seed + static_cast<uint64_t>(i)});
  }
}

std::vector<Trial> Evaluation::Trials(int runs, uint64_t seed) const {
  std::vector<Trial> trials;
  AddTrials(name(), runs, seed, &trials);
  return trials;
}

std::vector<std::unique_ptr<Evaluation>> AllEvaluations() {
  std::vector<std::unique_ptr<Evaluation>> all;
  all.push_back(MakeWatchEvaluation());
  all.push_back(MakeAssemblyEvaluation());
  all.push_back(MakeDisturbedEvaluation());
  all.push_back(MakeStopsEvaluation());
  all.push_back(MakeFromNothingEvaluation());
  all.push_back(MakeInsertionEvaluation());
  all.push_back(MakeKeyframesEvaluation());
  all.push_back(MakeSubstitutionEvaluation());
  all.push_back(MakeOneShowingEvaluation());
  all.push_back(MakeSufficientEvaluation());
  return all;
}

}  // namespace cell::cli
