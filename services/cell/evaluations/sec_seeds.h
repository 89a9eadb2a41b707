#pragma once

#include <string>
#include <vector>

#include "common/sec/relation_matrix.h"

namespace cell::cli {

/// A chain that noisy samples are made of.
struct SecSeed {
  std::string name;
  RelationMatrix chain;
};

/// The seeds of section VI-A. Objects have the paper's names, and each is a
/// type of its own; `roles` numbers the rows' roles.
///
/// The 3x5 chain of Fig. 12. The paper shows it as a picture; its relations are
/// those of a hand that takes hold of a box on a table, lifts it, and puts it
/// down.
SecSeed Figure12Seed(RoleTable* roles);
/// Seeds I to IV of Fig. 14: 4x6, 5x7, 6x8, 8x8.
std::vector<SecSeed> Figure14Seeds(RoleTable* roles);
/// Five manipulations that differ, for grouping: the chain of Fig. 12, seeds I,
/// II and IV (III is II with a row and a column more), and a hand that puts one
/// box on another.
std::vector<SecSeed> DistinctSeeds(RoleTable* roles);

}  // namespace cell::cli
