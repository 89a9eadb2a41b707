#include "services/cell/evaluations/variants_evaluation.h"

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "services/cell/evaluations/assembly_row.h"
#include "services/cell/evaluations/row_measures.h"
#include "services/cell/running/task_variant.h"

namespace cell::cli {
namespace {

using nlohmann::json;

constexpr char kVariants[] = "variants";
constexpr char kHelpedScript[] = "execution_helped";

class VariantsEvaluation final : public Evaluation {
 public:
  std::string name() const override { return kVariants; }
  std::string description() const override {
    return "Let the arms assemble the task's variants in turn (variants/), and "
           "a person do what\nthey ask for, no more.";
  }
  int default_runs() const override { return 20; }

  json RunTrial(const Trial& trial, const Deployment& deployment,
                const Roster& roster) const override {
    const std::vector<std::string> variants = VariantsOf(deployment.task_dir);
    if (variants.empty()) {
      throw std::runtime_error(
          (deployment.task_dir / kVariantsFolder).string() +
          ": should hold the variants of the task, but there is none");
    }
    const std::string& variant = variants[trial.seed % variants.size()];
    const VariedTask varied(deployment, variant);
    json row =
        RunAssembly(kHelpedScript, trial.seed, varied.deployment(), roster);
    row["variant"] = variant;
    return row;
  }

  RowShape row_shape() const override {
    return AssemblyRowShape().With({{"variant", RowShape::kText}});
  }

  std::vector<Measure> Measures(const std::vector<json>& rows) const override {
    return {RunsOf(rows, kVariants, "runs with a complete assembly",
                   [](const json& row) {
                     return row.at("complete") && row.at("state") == "done";
                   }),
            RunsOf(rows, kVariants, "runs without a breach of limits",
                   HasKeptLimits),
            RunsOf(rows, kVariants, "runs without a collision", HasHitNothing)};
  }

  /// Of each variant: the parts that a person had to help with.
  std::vector<Figure> Figures(const std::vector<json>& rows) const override {
    struct Sum {
      double num_touched = 0, num_runs = 0;
    };
    std::map<std::string, Sum> sums;
    for (const json& row : rows) {
      Sum& sum = sums[row.at("variant")];
      ++sum.num_runs;
      sum.num_touched += static_cast<double>(row.at("touched").size());
    }
    std::vector<Figure> figures;
    for (const auto& [variant, sum] : sums) {
      figures.push_back(
          {std::string(kVariants) + ": " + variant + ": parts helped with",
           sum.num_touched / sum.num_runs, "a run"});
    }
    return figures;
  }
};

}  // namespace

std::unique_ptr<Evaluation> MakeVariantsEvaluation() {
  return std::make_unique<VariantsEvaluation>();
}

}  // namespace cell::cli
