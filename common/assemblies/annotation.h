#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/assemblies/part_pair.h"

namespace cell::assemblies {

enum class Verb { kAttach, kDetach };
/// What an observer says of an action.
enum class Label { kCorrect, kMistake, kCorrection };
inline constexpr int kNumLabels = 3;
/// What kind of mistake an action is.
enum class MistakeKind {
  kNone,
  kWrongOrder,
  kWrongPosition,
  kShouldNotHaveHappened,
  kPreviousIsMistake
};

const char* NameOf(Verb verb);
const char* NameOf(Label label);
const char* NameOf(MistakeKind kind);  ///< "" for kNone

struct AssemblyAction {
  Verb verb = Verb::kAttach;
  PartPair pair;
  std::optional<Label> label;  ///< nullopt if not annotated
  MistakeKind kind = MistakeKind::kNone;
  int line = 0;  ///< of the file, from 1
};

/// One person's assembly of one toy, in the order of time.
struct AssemblySequence {
  std::string file;
  std::string toy;
  std::vector<AssemblyAction> actions;
};

}  // namespace cell::assemblies
