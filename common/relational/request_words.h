#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/config/config.h"
#include "common/relational/rule.h"
#include "common/relational/vocabulary.h"

namespace cell {

/// The texts that ask a person to do something with the hands: the section
/// `requests` of domain.yaml. {0}, {1} ... stand for the objects, in the order
/// of the arguments.
///
///   requests:                                     # optional, as is each entry
///     make_true: {Free: "take out of {0} what is in it"}
///     make_false: {Horizontal: "stand the {0} upright"}
///     do: {Insert: "put the {0} into {1}"}
class RequestWords {
 public:
  /// @throws ConfigError naming file:key: a predicate or action that is not
  /// there, a place for an argument that it has not.
  static RequestWords FromConfig(const Config& config,
                                 const Vocabulary& vocabulary,
                                 const std::vector<Action>& actions);

  /// "take out of frame.hole_1 what is in it"; nothing if the domain has no
  /// words for it.
  std::optional<std::string> ToMake(const GroundAtom& atom, bool is_true,
                                    const Vocabulary& vocabulary) const;
  /// The same for a literal without variables; `_` is told by its type: "take
  /// out of hole what is in it".
  std::optional<std::string> ToMake(const Literal& literal,
                                    const Vocabulary& vocabulary) const;
  /// "put the bolt_1 into frame.hole_1"; nothing as before.
  std::optional<std::string> ToDo(const std::string& action,
                                  const std::vector<int>& objects,
                                  const Vocabulary& vocabulary) const;

 private:
  using Templates = std::map<std::string, std::string>;  // by name

  Templates make_true_, make_false_, do_;
};

}  // namespace cell
