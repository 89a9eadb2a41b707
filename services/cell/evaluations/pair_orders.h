#pragma once

#include <set>
#include <utility>
#include <vector>

#include "common/assemblies/annotation.h"

namespace cell::cli {

/// Verdicts by precedence alone, as a control: an attach is a mistake if it
/// comes after another pair's although, wherever both occur, it came before
/// that; a detach is a correction if the attach was called a mistake.
std::vector<assemblies::Label> JudgeByPairOrders(
    const std::vector<const assemblies::AssemblySequence*>& training,
    const assemblies::AssemblySequence& judged);

}  // namespace cell::cli
