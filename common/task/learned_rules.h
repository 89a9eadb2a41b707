#pragma once

#include <string>

#include "common/config/config.h"
#include "common/config/deployment.h"
#include "common/relational/domain.h"

namespace cell {

/// Key of domain.yaml, optional: the file beside it with the rules that were
/// learned of the task's actions (`cell learn rules --out`):
///
///   learned_rules: rules.ndr
inline constexpr char kLearnedRulesKey[] = "learned_rules";

/// Gives the domain's actions the rules of the text. It may have been learned
/// when the task had other types and objects: names count.
/// @param file  the text's, for errors
/// @throws ConfigError "file:line: ..." for a rule that cannot be read, that
/// the domain has no words for, or whose action has rules already; naming the
/// file if it holds no rule
void PutLearnedRules(const std::string& text, const std::string& file,
                     Domain* domain);

/// The same with the file that `domain_config` names.
/// @throws ConfigError naming file:line, or file:key
void ReadLearnedRules(const Deployment& deployment, const Config& domain_config,
                      Domain* domain);

}  // namespace cell
