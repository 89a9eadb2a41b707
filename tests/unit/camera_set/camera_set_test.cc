// Camera sets in a small cell: what they publish, when, and of what.
#include "services/camera_set/camera_set.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>
#include <tuple>

#include "cell/alert_t.hpp"
#include "cell/truth_poses_t.hpp"
#include "common/bus/decode.h"
#include "common/bus/sim_bus.h"
#include "common/bus/truth_access.h"
#include "common/geometry/pose.h"
#include "common/rendering/cell_bodies.h"
#include "common/rendering/renderer.h"
#include "services/camera_set/rendered_view.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace camera_set;
namespace {

using testing::HasSubstr;
using testing::SizeIs;
using testing::ThrowsMessage;

const ShippedTask& TheTask() {
  static const ShippedTask task;
  return task;
}

// Everything on the table, a person's hand above it, moved a bit by `shift`.
TruthPoses SomeTruth(double shift = 0) {
  const ShippedTask& task = TheTask();
  TruthPoses truth;
  for (const Track& track : Stage(task).AllTracked().tracks) {
    truth.poses[track.name] = track.X_WO;
  }
  const Eigen::Isometry3d X_WG(Eigen::Translation3d(shift, -0.3, 0.2));
  const CellLayout::Hand& hand = task.layout.hands[0];
  AddHand(hand.type, hand.name, X_WG, 0.05, truth);
  return truth;
}

truth_poses_t ToMessage(const TruthPoses& truth) {
  truth_poses_t message{};
  message.header.utime = truth.utime;
  for (const auto& [name, X_WB] : truth.poses) {
    message.bodies.push_back({name, PoseToMessage(X_WB)});
  }
  message.num_bodies = static_cast<int32_t>(message.bodies.size());
  return message;
}

constexpr int32_t kNumTicks = 36;

// The clock: TRUTH_POSES every 4 ticks, of which the one of tick 24 is forged.
class World : public Service {
 public:
  explicit World(Bus& bus) {
    bus.Every(4, 0, [&bus] {
      if (bus.tick() == 4) bus.EndRunIn(kNumTicks);  // it begins after tick 0
      TruthPoses truth = SomeTruth(1e-3 * bus.tick());
      truth.utime = bus.now();
      truth_poses_t message = ToMessage(truth);
      if (bus.tick() == 24) message.bodies[0].pose_world_body.position[0] = NAN;
      bus.Publish("TRUTH_POSES", message);
    });
  }
};

std::map<std::string, ServiceFactory> Factories() {
  std::map<std::string, ServiceFactory> factories = {
      {"world", [](Bus& bus) {
         return std::make_unique<World>(bus);
       }}};
  for (const std::string set : {"1", "2", "3"}) {
    factories["camera_set@" + set] = [set](Bus& bus) {
      return MakeCameraSet(bus, ShippedDeployment(), set);
    };
  }
  return factories;
}

Roster TheRoster() {
  return {.task = "toy",
          .entries = {{"world", 1, ""},
                      {"camera_set@1", 4, "camera_renderer"},
                      {"camera_set@2", 4, "camera_renderer"},
                      {"camera_set@3", 4, "camera_renderer"}}};
}

std::vector<Message> Frames() {
  SimBus bus(TheRoster(), Factories());
  std::vector<Message> frames;
  while (bus.Step()) {
    for (const Message& message : bus.last_messages()) {
      if (message.channel.starts_with("FRAME_")) frames.push_back(message);
    }
  }
  return frames;
}

rgbd_frame_t DecodedMessage(const Message& message) {
  rgbd_frame_t frame{};
  const int size = static_cast<int>(message.bytes->size());
  EXPECT_EQ(frame.decode(message.bytes->data(), 0, size), size);
  return frame;
}

TEST(CameraSet, TakesAFrameEveryPeriodEachSetLaterThanTheOneBefore) {
  using Seen = std::tuple<std::string, int64_t, int32_t>;
  std::vector<Seen> seen;
  for (const Message& message : Frames()) {
    const rgbd_frame_t frame = DecodedMessage(message);
    EXPECT_EQ("FRAME_" + frame.camera, message.channel);
    seen.emplace_back(frame.camera, frame.header.utime / kTickUs,
                      frame.header.tick);
  }
  // Camera, tick of what it shows, tick of the message. The world begins with
  // tick 4. The truth of tick 24 was forged: the newest is that of tick 20.
  EXPECT_THAT(seen, testing::ElementsAre(Seen("1", 4, 7), Seen("2", 4, 7),
                                         Seen("3", 8, 11), Seen("1", 12, 15),
                                         Seen("2", 16, 19), Seen("3", 20, 23),
                                         Seen("1", 20, 27), Seen("2", 28, 31),
                                         Seen("3", 32, 35), Seen("1", 36, 39)));
}

// Nothing but black: already more than 10 bytes.
class BlackDevice : public FrameDevice {
 public:
  std::optional<RgbdFrame> Capture() override {
    if (++num_asked_ == 1) return std::nullopt;  // as one that begins
    RgbdFrame frame;
    frame.camera = "1";
    frame.view.width = frame.colour.width = frame.depth.width = 64;
    frame.view.height = frame.colour.height = frame.depth.height = 48;
    frame.colour.pixels.resize(64 * 48);
    frame.depth.counts.resize(64 * 48);
    return frame;
  }

 private:
  int num_asked_ = 0;
};

TEST(CameraSet, AFrameThatIsTooLongNamesTheKeysThatHelp) {
  CameraSet::Params params;
  params.camera = "1";
  params.max_bytes = 10;
  auto factories = Factories();
  factories["camera_set@1"] = [&](Bus& bus) {
    return std::make_unique<CameraSet>(bus, params,
                                       std::make_unique<BlackDevice>());
  };
  Roster roster = TheRoster();
  roster.entries.resize(2);
  roster.entries[1].latency = 1;  // it acts without being woken
  SimBus bus(roster, factories);
  std::vector<std::string> told;
  while (bus.Step()) {
    for (const Message& message : bus.last_messages()) {
      if (message.channel != "ALERT") continue;
      told.push_back(Decode<alert_t>(message)->text);
    }
  }
  EXPECT_THAT(told,
              testing::ElementsAre(testing::AllOf(
                  HasSubstr("longer than 10 bytes"),
                  HasSubstr("camera_set.yaml max_frame_kb"),
                  HasSubstr("net.core.rmem_max"), HasSubstr("rendered.size"))));
}

TEST(CameraSet, GivesTheSameBytesAgain) {
  const auto first = Frames();
  const auto second = Frames();
  ASSERT_EQ(first.size(), second.size());
  for (size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(*first[i].bytes, *second[i].bytes) << i;
    EXPECT_LE(first[i].bytes->size(), 150'000u);
  }
}

TEST(CameraSet, ADecodedDepthIsTheRenderedOne) {
  const CameraLayout& cameras = *TheTask().layout.cameras;
  const RenderScene scene(BodiesOf(TheTask().parts, TheTask().layout));
  const auto poses = cameras.Poses();
  int num_compared = 0;
  for (const Message& message : Frames()) {
    const auto frame = FrameFromMessage(DecodedMessage(message));
    ASSERT_TRUE(frame.has_value());
    const auto index = static_cast<size_t>(std::stoi(frame->camera) - 1);
    EXPECT_TRUE(frame->view.X_WC.isApprox(poses[index], 1e-12));
    const Camera camera =
        CameraWithView(poses[index], 640, 480, cameras.view_angles);
    const double shift = 1e-3 * static_cast<double>(frame->utime / kTickUs);
    const RenderImage image =
        Render(scene, SomeTruth(shift).poses, camera, {.has_shadows = false});
    ASSERT_THAT(frame->depth.counts, SizeIs(image.depth.size()));
    for (size_t i = 0; i < image.depth.size(); ++i) {
      const double depth = frame->depth_unit * frame->depth.counts[i];
      ASSERT_NEAR(depth, image.depth[i], 0.51 * frame->depth_unit) << i;
    }
    ++num_compared;
  }
  EXPECT_EQ(num_compared, 10);
}

TEST(CameraSet, SeesHandsAndParts) {
  RenderedView::Params params;
  const CameraLayout& cameras = *TheTask().layout.cameras;
  params.view =
      CameraWithView(cameras.Poses()[0], 640, 480, cameras.view_angles);
  const RenderedView view(BodiesOf(TheTask().parts, TheTask().layout), params);
  TruthPoses truth = SomeTruth();
  const auto all = view.Capture(truth).depth.counts;
  for (const char* prefix : {"hand_left.", "shaft"}) {
    TruthPoses without = truth;
    std::erase_if(without.poses, [&](const auto& entry) {
      return entry.first.starts_with(prefix);
    });
    EXPECT_NE(view.Capture(without).depth.counts, all) << prefix;
  }
}

TEST(DepthInCounts, RoundsAndIsZeroForWhatIsTooFar) {
  const DepthImage image = DepthInCounts(
      {0, 1, 1.00004F, 1.00006F, 6.5534F, 6.6F, 1e9F, INFINITY}, 8, 1, 1e-4);
  EXPECT_THAT(image.counts,
              testing::ElementsAre(0, 10000, 10000, 10001, 65534, 0, 0, 0));
}

TEST(CameraSet, MayReadTruthOnlyIfItRendersIt) {
  EXPECT_TRUE(MayReadTruth("camera_set@1", "camera_renderer"));
  EXPECT_FALSE(MayReadTruth("camera_set@1", "camera_set@1"));
  EXPECT_FALSE(MayReadTruth("planner", "camera_renderer"));
  Roster roster = TheRoster();
  roster.entries[1].truth_role = "";
  EXPECT_THROW(SimBus(roster, Factories()), std::logic_error);
}

TEST(CameraSet, RefusesASetThatTheCellDoesNotHave) {
  Stepper bus({.name = "camera_set@4", .truth_role = "camera_renderer"});
  for (const std::string set : {"4", "0", "left", "", "01"}) {
    EXPECT_THAT([&] { MakeCameraSet(bus, ShippedDeployment(), set); },
                ThrowsMessage<std::invalid_argument>(
                    HasSubstr("no camera set '" + set + "'")));
  }
}

// A device whose pictures cannot be made short: noise.
class Noise : public FrameDevice {
 public:
  std::optional<RgbdFrame> Capture() override {
    RgbdFrame frame;
    frame.view.width = frame.colour.width = frame.depth.width = 64;
    frame.view.height = frame.colour.height = frame.depth.height = 64;
    frame.colour.pixels.resize(64 * 64);
    std::mt19937 random(1);
    for (int i = 0; i < 64 * 64; ++i) {
      frame.depth.counts.push_back(static_cast<uint16_t>(random()));
    }
    return frame;
  }
};

TEST(CameraSet, SaysOnceThatItsFramesAreTooLong) {
  Stepper bus({.name = "camera_set@1"});
  CameraSet::Params params;
  params.period_ticks = 1;
  params.max_bytes = 2000;
  const CameraSet set(bus, params, std::make_unique<Noise>());
  std::vector<std::string> channels;
  for (int32_t tick = 0; tick < 3; ++tick) {
    ASSERT_EQ(bus.Accept(tick, {}), Stepper::State::kReady);
    for (const Message& m : bus.Run()) channels.push_back(m.channel);
  }
  EXPECT_EQ(std::ranges::count(channels, "ALERT"), 1);
  EXPECT_EQ(std::ranges::count(channels, "FRAME_1"), 0);
}

}  // namespace
}  // namespace cell
