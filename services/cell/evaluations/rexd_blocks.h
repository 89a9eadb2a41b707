#pragma once

#include <string>
#include <vector>

#include "services/cell/evaluations/rexd_statements.h"

namespace cell::cli {

/// What a run learns: a few episodes of each of several tasks, in turn.
struct BlockPlan {
  std::vector<std::string> names;
  std::vector<double> floors;  ///< actions of the shortest ways to the goals
  int num_episodes = 4;        ///< of each block

  int num_blocks() const { return static_cast<int>(names.size()); }
};

/// What is known at the beginning of a block: all that was learned in those
/// before it, or nothing.
inline constexpr char kCarriedOver[] = "carried over";
inline constexpr char kFromScratch[] = "from scratch";

/// The table of all blocks and episodes, for people and as CSV. A row has, for
/// each of the two, the lists actions, demonstrations, explorations and reached
/// with a number for each episode of all blocks.
std::string BlocksText(const BlockPlan& plan, const RexdGroup& group);
std::string BlocksCsv(const BlockPlan& plan,
                      const std::vector<RexdGroup>& groups);

/// Of such a row.
RowShape BlocksRowShape(const BlockPlan& plan);

/// Commands of gnuplot that draw the CSV, with error bars of one standard
/// deviation.
std::string BlocksPlot(const BlockPlan& plan,
                       const std::vector<RexdGroup>& groups,
                       const std::string& csv, const std::string& png);

/// Whether learning carries over: of each block but the first, that it needs
/// fewer demonstrations than from scratch, and that at most one is left to ask
/// for.
std::vector<RexdStatement> CheckBlockStatements(const BlockPlan& plan,
                                                const RexdGroup& group);

}  // namespace cell::cli
