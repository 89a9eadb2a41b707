#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/sec/learned_model.h"
#include "common/sec/scene_words.h"
#include "common/sec/sec_library.h"

namespace cell {

/// The SEC models that were learned. A manipulation agrees with a model by the
/// share of the model's facts that hold before and after it, where what else
/// has changed of the moved part counts against it:
///
///   agreement = held / (all + unexplained)
///
/// A literal weighs 2 and a relation 1; an unexplained change weighs as much as
/// the two facts that would say it, one before and one after. Unexplained
/// relations count only with the table and what is fixed: which of its
/// neighbours a part touches is chance. A literal that the scene leaves open
/// counts half.
///
/// The agreement is 0 unless the predicates of the moved part change as the
/// model says. Where the poses leave one of them open, relations decide: those
/// of the moved part with roles, the table and what is fixed must change as the
/// model says, and it must come to touch something that the model names.
///
/// Also a part of a type that was never shown is taken for the moved one, if it
/// can stand in for it (StandIns()).
class LearnedLibrary final : public SecLibrary {
 public:
  struct Entry {
    std::string action;
    LearnedModel model;
  };
  static constexpr double kThreshold = 0.45;

  LearnedLibrary(std::vector<Entry> entries,
                 std::shared_ptr<const SceneWords> words);

  const Models& models() const override { return models_; }
  double threshold() const override { return kThreshold; }

 private:
  Models models_;
};

}  // namespace cell
