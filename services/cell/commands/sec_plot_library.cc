#include "services/cell/commands/sec_plot_library.h"

#include <fmt/format.h>

#include <iostream>
#include <stdexcept>

#include "common/node/cell_files.h"
#include "common/sec/chain_similarities.h"
#include "common/sec/library_members.h"
#include "common/sec/sec_learner.h"
#include "common/text/counted.h"
#include "services/cell/commands/library_models.h"
#include "services/cell/commands/sec_commands.h"
#include "services/cell/pictures/figure_file.h"
#include "services/cell/pictures/library_figure.h"

namespace cell::cli {
namespace {

LibraryFigure::Model FigureModelOf(const std::string& name,
                                   const LearnedModel& model, size_t number,
                                   const LibraryMembers& members) {
  LibraryFigure::Model drawn{name, model.chain, {}, members.OfModel(number)};
  for (size_t k = 0; k < members.names.size(); ++k) {
    if (members.model_of[k] == number)
      drawn.members.push_back(members.names[k]);
  }
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
  const LibraryMembers members = CompareMembers(models, words, *chains);
  for (const auto& [name, model] : models) {
    figure.models.push_back(
        FigureModelOf(name, model, figure.models.size(), members));
  }
  figure.of_members = HistogramOf(members);
  file.Write(SizeOf(figure),
             [&](Canvas* canvas) { DrawLibrary(figure, canvas); });
  std::cout << fmt::format(
      "{} shows {}\n", options.out,
      Counted(static_cast<int64_t>(figure.models.size()), "model"));
  return 0;
}

}  // namespace cell::cli
