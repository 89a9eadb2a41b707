// Do the camera sets stand where they see the task? As the world lays it out.
#include <gmock/gmock.h>

#include "common/bus/sim_bus.h"
#include "common/rendering/cell_bodies.h"
#include "common/rendering/renderer.h"
#include "services/cell/running/service_registry.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace cli;
namespace {

TruthPoses TruthAtStart(const std::string& demonstration, uint64_t seed) {
  const Deployment deployment = ShippedDeployment();
  Roster roster = Roster::FromConfig(deployment.ForService("roster"));
  roster.entries.resize(1);  // the world alone
  SimBus bus(roster, AllServices(deployment, demonstration, seed));
  while (bus.Step()) {
    for (const Message& message : bus.last_messages()) {
      if (message.channel != "TRUTH_POSES") continue;
      truth_poses_t poses{};
      poses.decode(message.bytes->data(), 0,
                   static_cast<int>(message.bytes->size()));
      return *TruthFromMessage(poses);
    }
  }
  throw std::runtime_error("the world shows nothing");
}

TEST(CameraView, AtLeastTwoSetsSeeEachPartAtTheStart) {
  constexpr int kLeastPixels = 30;
  const ShippedTask task;
  const RenderScene scene(BodiesOf(task.parts, task.layout));
  const CameraLayout& cameras = *task.layout.cameras;
  for (const std::string demonstration : {"assembly", "execution"}) {
    for (const uint64_t seed : {1, 2, 3, 4, 5}) {
      const TruthPoses truth = TruthAtStart(demonstration, seed);
      std::map<std::string, int> num_views;
      for (const auto& X_WC : cameras.Poses()) {
        const RenderImage image =
            Render(scene, truth.poses,
                   CameraWithView(X_WC, 640, 480, cameras.view_angles),
                   {.has_shadows = false});
        for (const auto& [body, num] : image.NumPixels()) {
          num_views[scene.bodies()[static_cast<size_t>(body)].name] +=
              num >= kLeastPixels;
        }
      }
      for (const Part& part : task.parts.parts()) {
        EXPECT_GE(num_views[part.name], 2)
            << part.name << ", " << demonstration << " " << seed;
      }
    }
  }
}

}  // namespace
}  // namespace cell
