#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/assemblies/annotation.h"

namespace cell::assemblies {

/// What is odd about a line, and what was made of it.
struct AnnotationProblem {
  enum class Kind {
    kEmptyFile,
    kNoToy,
    kMissingColumns,
    kMissingName,
    kVerbAsPart,
    kRepeatedRow,
    kBadFrames,
    kUnknownVerb,
    kUnknownLabel,
    kMissingRemark,
    kUnknownRemark,
    kOnePart
  };
  Kind kind = Kind::kEmptyFile;
  std::string file;
  int line = 0;
  std::string text;
};
inline constexpr int kNumProblemKinds = 12;
/// Of many problems of a kind: "rows without all columns".
const char* NameOf(AnnotationProblem::Kind kind);
/// "file:line: text"
std::string Show(const AnnotationProblem& problem);

struct AnnotationFile {
  AssemblySequence sequence;
  std::vector<AnnotationProblem> problems;
  int num_rows = 0;     ///< lines that are not blank, without a heading
  int num_skipped = 0;  ///< rows that are no action
};

/// The toy in a file name "..._ACTOR-TOY_...", such as c13a in
/// "action_both_9033-c13a_9033_user.csv"; empty if there is none.
std::string ToyOf(std::string_view file_name);

/// Reads annotated actions, one row each, separated by commas: first frame,
/// last frame, attach or detach, one part, the other part, correct or mistake
/// or correction, remark. A heading in line 1 is allowed.
///
/// No row stops the reading. A row without parts is skipped, and one with
/// a verb where a part should be. A verb that is none and is like none is read
/// by the evidence: the two parts are detached if they are attached, and
/// attached if not. A row without a known label stays, unjudged. Misspelt words
/// are read as the nearest. Each of these is a problem with its line.
AnnotationFile ReadAnnotations(std::string_view text, const std::string& file);

}  // namespace cell::assemblies
