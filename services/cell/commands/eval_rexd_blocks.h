#pragma once

#include "services/cell/commands/eval_rexd_options.h"

namespace cell::cli {

/// Learns the blocks one after the other, and each from scratch with the same
/// seeds, and prints what learning carries over. Returns the exit code.
/// @throws RuleError, std::runtime_error naming the file
int EvalBlocks(const EvalRexdOptions& options);

}  // namespace cell::cli
