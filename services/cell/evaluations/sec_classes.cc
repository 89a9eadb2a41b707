#include "services/cell/evaluations/sec_classes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <stdexcept>

#include "common/sec/chain_noise.h"
#include "common/sec/derivative_similarity.h"
#include "common/sec/joint_similarity.h"
#include "common/sec/paper_similarity.h"
#include "common/sec/typed_similarity.h"
#include "services/cell/evaluations/size_control.h"

namespace cell::cli {
namespace {

constexpr int kNumLevels = 11;
constexpr double kFalseAccepts = 0.01;

using Classes = std::vector<RelationMatrix>;

struct NamedMeasure {
  std::string name;
  std::unique_ptr<MatrixSimilarity> measure;
};

std::vector<NamedMeasure> AllMeasures() {
  std::vector<NamedMeasure> measures;
  measures.push_back({"paper", std::make_unique<PaperSimilarity>()});
  measures.push_back({"derivative", std::make_unique<DerivativeSimilarity>()});
  measures.push_back({"joint", std::make_unique<JointSimilarity>()});
  measures.push_back({"typed", std::make_unique<TypedSimilarity>()});
  measures.push_back({"size only", std::make_unique<SizeControl>()});
  return measures;
}

class Generator {
 public:
  explicit Generator(const SecClassesParams& params)
      : params_(params), random_(params.seed) {
    if (params.num_rows < 3 || params.num_columns < 2) {
      throw std::invalid_argument(
          "classes need at least 3 rows and 2 columns each");
    }
    for (uint32_t role = 0; role + 2 < params.num_rows; ++role) {
      roles_.push_back(role);
    }
  }

  Classes MakeClasses() {
    Classes classes;
    for (int i = 0; i < params_.num_classes; ++i) {
      std::vector<uint32_t> roles;
      for (size_t row = 0; row < params_.num_rows; ++row) {
        roles.push_back(roles_[params_.has_equal_roles
                                   ? row % roles_.size()
                                   : DrawBelow(roles_.size(), random_)]);
      }
      classes.push_back(
          RandomChain(roles, params_.num_columns, random_).Sorted());
    }
    return classes;
  }

  /// Sample i is of class i, i - num_classes ...
  Classes MakeSamples(const Classes& classes, double noise) {
    Classes samples;
    for (int i = 0; i < params_.num_samples; ++i) {
      const auto& original = classes[static_cast<size_t>(i) % classes.size()];
      samples.push_back(
          WithNoise(original, {noise, true, roles_}, random_).Sorted());
    }
    return samples;
  }

 private:
  SecClassesParams params_;
  std::mt19937_64 random_;
  std::vector<uint32_t> roles_;
};

std::pair<size_t, double> Nearest(const RelationMatrix& sample,
                                  const Classes& classes,
                                  const MatrixSimilarity& measure) {
  std::pair<size_t, double> best{0, -1};
  for (size_t i = 0; i < classes.size(); ++i) {
    const double similarity = measure.Between(sample, classes[i]);
    if (similarity > best.second) best = {i, similarity};
  }
  return best;
}

SecClassesResult Classify(double noise, const NamedMeasure& measure,
                          const Classes& classes, const Classes& known,
                          const Classes& unseen) {
  SecClassesResult result{noise, measure.name, {}, {}};
  for (size_t i = 0; i < known.size(); ++i) {
    const auto [nearest, similarity] =
        Nearest(known[i], classes, *measure.measure);
    result.known.push_back({similarity, nearest == i % classes.size()});
  }
  for (const RelationMatrix& sample : unseen) {
    result.unseen.push_back(Nearest(sample, classes, *measure.measure).second);
  }
  std::ranges::sort(result.unseen);
  return result;
}

const SecClassesResult& ResultOf(const std::string& measure, double noise,
                                 const std::vector<SecClassesResult>& results) {
  return *std::ranges::find_if(results, [&](const SecClassesResult& result) {
    return result.measure == measure && std::abs(result.noise - noise) < 0.01;
  });
}

}  // namespace

int SecClassesResult::num_right() const {
  return static_cast<int>(std::ranges::count_if(known, &Sample::is_right));
}

double SecClassesResult::area() const {
  double wins = 0;
  for (const Sample& sample : known) {
    const auto [first, last] =
        std::ranges::equal_range(unseen, sample.similarity);
    wins += static_cast<double>(first - unseen.begin()) +
            0.5 * static_cast<double>(last - first);
  }
  return wins / static_cast<double>(known.size() * unseen.size());
}

int SecClassesResult::NumAcceptedRight(double threshold) const {
  return static_cast<int>(
      std::ranges::count_if(known, [&](const Sample& sample) {
        return sample.is_right && sample.similarity >= threshold;
      }));
}

double SecClassesResult::FalseAccepts(double threshold) const {
  const auto first = std::ranges::lower_bound(unseen, threshold);
  return static_cast<double>(unseen.end() - first) /
         static_cast<double>(unseen.size());
}

std::vector<SecClassesResult> ClassifySamples(
    const SecClassesParams& params,
    const std::function<void(const std::string&)>& show) {
  Generator generator(params);
  const Classes classes = generator.MakeClasses();
  const Classes never_known = generator.MakeClasses();
  const auto measures = AllMeasures();
  std::vector<SecClassesResult> results;
  for (int level = 0; level < kNumLevels; ++level) {
    const double noise = static_cast<double>(level) / (kNumLevels - 1);
    const Classes known = generator.MakeSamples(classes, noise);
    const Classes unseen = generator.MakeSamples(never_known, noise);
    for (const NamedMeasure& measure : measures) {
      show(fmt::format("p = {:.1f}, {}", noise, measure.name));
      results.push_back(Classify(noise, measure, classes, known, unseen));
    }
  }
  return results;
}

double ThresholdFor(double share, const std::string& measure,
                    const std::vector<SecClassesResult>& results) {
  std::vector<double> unseen;
  for (const SecClassesResult& result : results) {
    if (result.measure != measure) continue;
    unseen.insert(unseen.end(), result.unseen.begin(), result.unseen.end());
  }
  std::ranges::sort(unseen, std::greater());
  const auto num_accepted =
      static_cast<size_t>(share * static_cast<double>(unseen.size()));
  // The first that has to be refused.
  return std::nextafter(unseen.at(num_accepted), 2.0);
}

std::vector<Measure> ClassMeasures(
    const std::vector<SecClassesResult>& results) {
  std::vector<Measure> measures;
  const auto add = [&](const std::string& name, const SecClassesResult& result,
                       int num_good, double goal) {
    measures.push_back({name, num_good, static_cast<int>(result.known.size()),
                        std::nullopt, goal});
  };
  const auto& typed = ResultOf("typed", 0.4, results);
  add("typed: right at p = 0.4", typed, typed.num_right(), 0.98);
  const auto& joint = ResultOf("joint", 0.3, results);
  add("joint: right at p = 0.3", joint, joint.num_right(), 0.94);
  const double threshold = ThresholdFor(kFalseAccepts, "typed", results);
  for (const double noise : {0.0, 0.1, 0.2, 0.3}) {
    const auto& result = ResultOf("typed", noise, results);
    add(fmt::format("typed: accepted from {:.3f} and right at p = {:.1f}",
                    threshold, noise),
        result, result.NumAcceptedRight(threshold), 0.9);
  }
  return measures;
}

std::string ClassesToCsv(const std::vector<SecClassesResult>& results) {
  std::string text = "p,measure,samples,right,accuracy,low,high,roc_area\n";
  for (const SecClassesResult& result : results) {
    const auto num_all = static_cast<int>(result.known.size());
    const Interval interval = WilsonInterval(result.num_right(), num_all);
    text +=
        fmt::format("{:.1f},{},{},{},{:.4f},{:.4f},{:.4f},{:.4f}\n",
                    result.noise, result.measure, num_all, result.num_right(),
                    static_cast<double>(result.num_right()) / num_all,
                    interval.low, interval.high, result.area());
  }
  return text;
}

std::string RocToCsv(const std::vector<SecClassesResult>& results) {
  constexpr int kSteps = 50;
  std::string text = "p,measure,threshold,false_accepts,accepted_right\n";
  for (const SecClassesResult& result : results) {
    for (int step = 0; step <= kSteps; ++step) {
      const double threshold = static_cast<double>(step) / kSteps;
      text +=
          fmt::format("{:.1f},{},{:.2f},{:.4f},{:.4f}\n", result.noise,
                      result.measure, threshold, result.FalseAccepts(threshold),
                      result.NumAcceptedRight(threshold) /
                          static_cast<double>(result.known.size()));
    }
  }
  return text;
}

std::string ClassesPlot(const std::string& accuracy_csv,
                        const std::string& png) {
  std::string text = fmt::format(
      "set terminal pngcairo size 960,640\nset output '{}'\n"
      "set datafile sep ','\nset key outside\nset grid\n"
      "set xlabel 'noise level p'\nset ylabel 'classified right (%)'\n"
      "set yrange [0:105]\nplot ",
      png);
  const auto measures = AllMeasures();
  for (size_t i = 0; i < measures.size(); ++i) {
    text += fmt::format(
        "{}'{}' every {}::{} using 1:(100*$5):(100*$6):(100*$7) with "
        "yerrorlines title '{}'",
        i == 0 ? "" : ", ", accuracy_csv, measures.size(), i + 1,
        measures[i].name);
  }
  return text + "\n";
}

}  // namespace cell::cli
