#include "services/cell/evaluations/mistakes_evaluation.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/assemblies/sequence_judge.h"
#include "common/rules/simulation.h"
#include "services/cell/evaluations/pair_orders.h"

namespace cell::cli {
namespace {

using assemblies::AssemblyAction;
using assemblies::AssemblyModel;
using assemblies::AssemblySequence;
using assemblies::JudgeSettings;
using assemblies::Label;
using assemblies::MistakeKind;
using assemblies::OrderEvidence;
using assemblies::OrderPrior;
using assemblies::SequenceJudge;
using assemblies::Verb;
using assemblies::Verdict;

using Sequences = std::vector<const AssemblySequence*>;
using Show = std::function<void(const std::string&)>;

OrderEvidence EvidenceOf(const Sequences& sequences) {
  return assemblies::CollectEvidence(sequences);
}

std::vector<JudgeSettings> AllSettings() {
  std::vector<JudgeSettings> all;
  for (const double probability : {0.35, 0.3, 0.4, 0.5}) {
    for (const bool builds : {true, false}) {
      for (const double position : {0.25, 0.4, 2.0}) {
        all.push_back({probability, builds, position});
      }
    }
  }
  return all;
}

Sequences Without(const Sequences& sequences, size_t left_out) {
  Sequences others = sequences;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
  return others;
}

std::vector<Verdict> JudgeAll(const AssemblySequence& sequence,
                              const AssemblyModel& model,
                              const JudgeSettings& settings) {
  SequenceJudge judge(model, settings);
  std::vector<Verdict> verdicts;
  for (const AssemblyAction& action : sequence.actions) {
    verdicts.push_back(judge.Judge(action.verb, action.pair));
  }
  return verdicts;
}

/// Judges a sequence by each of the settings; learns only where it must.
void AddCounts(const AssemblySequence& sequence, const OrderEvidence& toy,
               const OrderPrior& prior,
               const std::vector<JudgeSettings>& settings, double weight,
               std::vector<LabelCounts>* counts) {
  AssemblyModel model;
  for (size_t i = 0; i < settings.size(); ++i) {
    if (i == 0 ||
        settings[i].least_probability != settings[i - 1].least_probability) {
      model = LearnModel(toy, prior, settings[i]);
    }
    const auto verdicts = JudgeAll(sequence, model, settings[i]);
    for (size_t k = 0; k < verdicts.size(); ++k) {
      if (const auto label = sequence.actions[k].label) {
        (*counts)[i].Add(*label, verdicts[k].label, weight);
      }
    }
  }
}

/// The settings that judge the toys best, each sequence by the others.
JudgeSettings ChooseSettings(const ToySequences& toys, const Show& show,
                             const std::string& what) {
  const std::vector<JudgeSettings> settings = AllSettings();
  std::vector<LabelCounts> counts(settings.size());
  std::map<std::string, OrderEvidence> evidence;
  OrderPrior prior;
  for (const auto& [toy, sequences] : toys) {
    prior.Add(evidence[toy] = EvidenceOf(sequences));
  }
  int num_done = 0;
  for (const auto& [toy, sequences] : toys) {
    show(fmt::format("{}: toy {} of {}", what, ++num_done, toys.size()));
    if (sequences.size() < 2) continue;
    prior.Remove(evidence[toy]);
    for (size_t i = 0; i < sequences.size(); ++i) {
      AddCounts(*sequences[i], EvidenceOf(Without(sequences, i)), prior,
                settings, 1.0 / static_cast<double>(sequences.size()), &counts);
    }
    prior.Add(evidence[toy]);
  }
  const auto best = std::ranges::max_element(counts, {}, &LabelCounts::MacroF1);
  return settings[static_cast<size_t>(best - counts.begin())];
}

template <class T>
void Shuffle(std::vector<T>* values, rules::RandomNumbers* random) {
  for (size_t i = values->size(); i > 1; --i) {
    const auto j = static_cast<size_t>(random->Below(static_cast<int>(i)));
    std::swap((*values)[i - 1], (*values)[j]);
  }
}

class MistakesRun {
 public:
  MistakesRun(const ToySequences& toys, const MistakesOptions& options,
              const Show& show)
      : toys_(toys), options_(options), show_(show), random_(options.seed) {}

  MistakesResult Run() {
    ChooseAll();
    for (int split = 0; split < options_.num_splits; ++split) {
      show_(fmt::format("split {} of {}", split + 1, options_.num_splits));
      RunSplit();
    }
    return std::move(result_);
  }

 private:
  void ChooseAll() {
    std::vector<std::string> names;
    for (const auto& [toy, sequences] : toys_) names.push_back(toy);
    Shuffle(&names, &random_);
    const int num_folds = options_.is_nested ? options_.num_folds : 1;
    for (int fold = 0; fold < num_folds; ++fold) {
      ToySequences others = toys_;
      std::vector<std::string> members;
      for (size_t i = 0; i < names.size(); ++i) {
        if (static_cast<int>(i) % num_folds == fold) {
          members.push_back(names[i]);
          others.erase(names[i]);
        }
      }
      const JudgeSettings settings =
          options_.is_nested ? ChooseSettings(others, show_,
                                              fmt::format("settings {} of {}",
                                                          fold + 1, num_folds))
                             : JudgeSettings{};
      result_.chosen.push_back(settings);
      for (const std::string& toy : members) settings_[toy] = settings;
    }
  }

  void RunSplit() {
    std::map<std::string, size_t> judged;
    std::map<std::string, Sequences> training;
    std::map<std::string, OrderEvidence> evidence;
    OrderPrior prior;
    for (const auto& [toy, sequences] : toys_) {
      training[toy] = sequences;
      if (sequences.size() >= 2) {
        judged[toy] = static_cast<size_t>(
            random_.Below(static_cast<int>(sequences.size())));
        training[toy] = Without(sequences, judged[toy]);
      }
      prior.Add(evidence[toy] = EvidenceOf(training[toy]));
    }
    for (const auto& [toy, index] : judged) {
      prior.Remove(evidence[toy]);
      JudgeOne(toy, *toys_.at(toy)[index], training[toy],
               LearnModel(evidence[toy], prior, settings_[toy]));
      prior.Add(evidence[toy]);
    }
  }

  void JudgeOne(const std::string& toy, const AssemblySequence& sequence,
                const Sequences& training, const AssemblyModel& model) {
    ToyResult& result = result_.toys[toy];
    result.settings = settings_[toy];
    result.controls.resize(kNumControls);
    result.num_sequences = static_cast<int>(training.size()) + 1;
    const auto verdicts = JudgeAll(sequence, model, settings_[toy]);
    const auto by_order = JudgeByPairOrders(training, sequence);
    for (size_t i = 0; i < verdicts.size(); ++i) {
      const AssemblyAction& action = sequence.actions[i];
      if (!action.label) {
        ++result_.num_unlabelled;
        continue;
      }
      ++result.num_actions;
      result.counts.Add(*action.label, verdicts[i].label);
      const Label controls[] = {
          Label::kCorrect,
          action.verb == Verb::kDetach ? Label::kMistake : Label::kCorrect,
          by_order[i]};
      for (size_t k = 0; k < kNumControls; ++k) {
        result.controls[k].Add(*action.label, controls[k]);
      }
      AddKind(action, verdicts[i]);
    }
  }

  void AddKind(const AssemblyAction& action, const Verdict& verdict) {
    const std::string remark = NameOf(action.kind);
    KindRow& row = result_.kinds[fmt::format(
        "{} {}{}{}", NameOf(action.verb), NameOf(*action.label),
        remark.empty() ? "" : ": ", remark)];
    ++row.verdicts[verdict.label];
    row.num_same_kind += *action.label == Label::kMistake &&
                         verdict.label == Label::kMistake &&
                         verdict.kind == action.kind;
  }

  const ToySequences& toys_;
  MistakesOptions options_;
  const Show& show_;
  rules::RandomNumbers random_;
  std::map<std::string, JudgeSettings> settings_;  // by toy
  MistakesResult result_;
};

}  // namespace

const char* NameOf(Control control) {
  constexpr const char* kNames[] = {"majority class", "every detach a mistake",
                                    "precedence of pairs"};
  return kNames[static_cast<int>(control)];
}

ToySequences GroupByToy(const std::vector<AssemblySequence>& sequences) {
  ToySequences toys;
  for (const AssemblySequence& sequence : sequences) {
    toys[sequence.toy].push_back(&sequence);
  }
  return toys;
}

MistakesResult EvaluateMistakes(const ToySequences& toys,
                                const MistakesOptions& options,
                                const Show& show) {
  return MistakesRun(toys, options, show).Run();
}

}  // namespace cell::cli
