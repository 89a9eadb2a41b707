#include "services/cell/evaluation.h"

#include "services/cell/assembly_evaluation.h"
#include "services/cell/insertion_evaluation.h"
#include "services/cell/watch_evaluation.h"

namespace cell {

std::vector<std::unique_ptr<Evaluation>> AllEvaluations() {
  std::vector<std::unique_ptr<Evaluation>> all;
  all.push_back(MakeWatchEvaluation());
  all.push_back(MakeAssemblyEvaluation());
  all.push_back(MakeInsertionEvaluation());
  return all;
}

}  // namespace cell
