#pragma once

#include <gmock/gmock.h>

#include <memory>

#include "common/sec/chain_similarities.h"
#include "common/sec/role_similarity.h"
#include "tests/unit/stage_testing.h"

namespace cell {

/// The event chains of the shipped task's actions, and what they are compared
/// by.
class ShownLibrary : public testing::Test {
 protected:
  ShownLibrary() {
    for (const ActionModel& model : task_.actions) {
      if (model.sec) models_.emplace(model.action.name, *model.sec);
    }
  }

  const ShippedTask task_;
  const SceneWords words_{task_.domain.vocabulary(), task_.parts};
  const std::unique_ptr<ChainSimilarity> chains_ =
      MakeChainSimilarity("same_row");
  RoleSimilarity::Models models_;
};

}  // namespace cell
