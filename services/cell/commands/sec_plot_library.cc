#include "services/cell/commands/sec_plot_library.h"

#include <fmt/format.h>

#include <iostream>
#include <stdexcept>

#include "common/node/cell_files.h"
#include "common/sec/chain_similarities.h"
#include "common/sec/sec_learner.h"
#include "common/text/counted.h"
#include "services/cell/commands/library_models.h"
#include "services/cell/commands/sec_commands.h"
#include "services/cell/pictures/figure_file.h"
#include "services/cell/pictures/library_figure.h"

namespace cell::cli {
namespace {

/// What one demonstration has taught of a model, as a model of its own.
LearnedModel ModelOf(const Contribution& contribution,
                     const LearnedModel& model) {
  LearnedModel own = model;
  for (size_t role = 0; role < own.roles.size(); ++role) {
    own.roles[role].type = contribution.types[role];
  }
  own.pick = contribution.pick;
  own.place = contribution.place;
  own.chain = contribution.chain;
  own.shown = contribution.shown;
  own.taught = {contribution};
  return own;
}

/// "assembly 1" or, of several demonstrations, "assembly 1 and 2 others".
std::string NameOf(const Contribution& contribution) {
  const auto& shown = contribution.shown;
  if (shown.empty()) return "?";
  if (shown.size() == 1) return shown.begin()->first;
  return fmt::format("{} and {}", shown.begin()->first,
                     Counted(static_cast<int64_t>(shown.size()) - 1, "other"));
}

LibraryFigure::Model FigureModelOf(const std::string& name,
                                   const LearnedModel& model,
                                   const SceneWords& words,
                                   const ChainSimilarity& chains) {
  LibraryFigure::Model drawn{name, model.chain, {}, {}};
  RoleSimilarity::Models members;
  for (size_t k = 0; k < model.taught.size(); ++k) {
    drawn.members.push_back(NameOf(model.taught[k]));
    members.emplace(fmt::format("{:08}", k), ModelOf(model.taught[k], model));
  }
  drawn.of_members = RoleSimilarity(members, words, chains).OfActions();
  return drawn;
}

}  // namespace

int PlotLibrary(const LibraryPlotOptions& options) {
  const FigureFile file{options.out, kChooseAnotherOut};
  file.Require();
  const Task task = LoadTask(FindCellFiles(options.deploy_dir).deployment);
  const RoleSimilarity::Models models = ModelsOf(options.database, task);
  if (models.empty()) {
    throw std::runtime_error("no action has been learned; cell learn sec");
  }
  const SceneWords words{task.domain.vocabulary(), task.parts};
  const auto chains = MakeChainSimilarity(SecLearner::kMeasure);
  LibraryFigure figure;
  figure.threshold = SecLearner::Params{}.threshold;
  figure.of_models = RoleSimilarity(models, words, *chains).OfActions();
  for (const auto& [name, model] : models) {
    figure.models.push_back(FigureModelOf(name, model, words, *chains));
  }
  file.Write(SizeOf(figure),
             [&](Canvas* canvas) { DrawLibrary(figure, canvas); });
  std::cout << fmt::format(
      "{} shows {}\n", options.out,
      Counted(static_cast<int64_t>(figure.models.size()), "model"));
  return 0;
}

}  // namespace cell::cli
