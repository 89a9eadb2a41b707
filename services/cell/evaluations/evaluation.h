#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/roster.h"
#include "common/config/deployment.h"
#include "services/cell/evaluations/row_shape.h"
#include "services/cell/scoring/interval.h"

namespace cell::cli {

/// One figure of an evaluation, beside the paper's and the goal.
struct Measure {
  std::string name;
  int num_good = 0;
  int num_all = 0;
  std::optional<double> paper;  ///< rate that the paper reports
  double goal = 1;              ///< least rate that is aimed at

  double value() const { return num_all > 0 ? 1.0 * num_good / num_all : 0; }
  Interval interval() const { return WilsonInterval(num_good, num_all); }
  bool is_met() const { return num_all > 0 && value() >= goal; }
  /// "met" only if the whole interval meets the goal: a rate of a few trials is
  /// not enough.
  std::string verdict() const;
};

/// A number that an evaluation reports beside its measures.
struct Figure {
  std::string name;
  double value = 0;
  std::string unit;
};

/// One run of an evaluation.
struct Trial {
  std::string group;
  uint64_t seed = 0;
};

/// Runs of one kind.
struct TrialGroup {
  std::string name;
  double share = 1;  ///< of the number of runs that is asked for
  int least = 1;     ///< runs, however few are asked for
};

/// What `cell eval NAME` measures. Each trial becomes one row (JSON); the
/// measures are a function of the rows.
class Evaluation {
 public:
  Evaluation() = default;
  Evaluation(const Evaluation&) = delete;
  Evaluation& operator=(const Evaluation&) = delete;
  virtual ~Evaluation() = default;
  virtual std::string name() const = 0;
  virtual std::string description() const = 0;
  virtual int default_runs() const = 0;
  /// By default one group, which has the evaluation's name.
  virtual std::vector<TrialGroup> groups() const { return {{name()}}; }
  /// Of each group, with seeds from `seed` on; with `group`, of this one only,
  /// and all `runs` of it.
  std::vector<Trial> Trials(int runs, uint64_t seed,
                            const std::string& group = "") const;
  virtual nlohmann::json RunTrial(const Trial& trial,
                                  const Deployment& deployment,
                                  const Roster& roster) const = 0;
  /// Of a row: all that Measures() and Figures() read of it, besides the
  /// group.
  virtual RowShape row_shape() const = 0;
  virtual std::vector<Measure> Measures(
      const std::vector<nlohmann::json>& rows) const = 0;
  virtual std::vector<Figure> Figures(
      const std::vector<nlohmann::json>& /*rows*/) const {
    return {};
  }
};

/// Everything that `cell eval` knows.
std::vector<std::unique_ptr<Evaluation>> AllEvaluations();

}  // namespace cell::cli
