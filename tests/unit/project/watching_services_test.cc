// tracker, sec_builder, recognizer and predicate_estimator on steppers, fed
// with a scripted world.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cell/alert_t.hpp"
#include "cell/episode_t.hpp"
#include "cell/key_frame_t.hpp"
#include "cell/predicates_t.hpp"
#include "cell/recognised_action_t.hpp"
#include "cell/sense_request_t.hpp"
#include "cell/status_t.hpp"
#include "cell/tracks_t.hpp"
#include "cell/truth_poses_t.hpp"
#include "common/bus/stepper.h"
#include "common/geometry/pose.h"
#include "services/planner/planner.h"
#include "services/predicate_estimator/predicate_estimator.h"
#include "services/recognizer/recognizer.h"
#include "services/sec_builder/sec_builder.h"
#include "services/tracker/tracker.h"
#include "tests/test_folder.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace planner;
using namespace predicate_estimator;
using namespace recognizer;
using namespace sec_builder;
using namespace tracker;
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

template <class M>
M Decoded(const Message& message) {
  M decoded{};
  EXPECT_EQ(decoded.decode(message.bytes->data(), 0,
                           static_cast<int>(message.bytes->size())),
            static_cast<int>(message.bytes->size()));
  return decoded;
}

// The four services; a message of tick k reaches the others in k + 1.
class Watchers {
 public:
  explicit Watchers(const Deployment& deployment = ShippedDeployment()) {
    Add("tracker", "tracker_ideal", MakeTracker, deployment);
    Add("sec_builder", "", MakeSecBuilder, deployment);
    Add("recognizer", "", MakeRecognizer, deployment);
    Add("predicate_estimator", "", MakePredicateEstimator, deployment);
  }
  void AddPlanner() { Add("planner", "", MakePlanner, ShippedDeployment()); }
  /// No service hears this key frame.
  void LoseKeyFrame(int32_t seq) { lost_key_frame_ = seq; }

  /// Makes a tick with these messages of the clock's.
  template <class... M>
  void Tick(const std::pair<const char*, M>&... clocks) {
    std::vector<Message> inputs = std::move(sent_);
    sent_.clear();
    std::erase_if(inputs, [this](const Message& message) {
      return message.channel == "KEY_FRAME" && message.seq == lost_key_frame_;
    });
    (inputs.push_back(Clocks(clocks.first, clocks.second)), ...);
    for (const auto& stepper : steppers_) {
      std::vector<Message> wanted;
      for (const Message& message : inputs) {
        if (stepper->Wants(message.channel)) wanted.push_back(message);
      }
      if (stepper->Accept(tick_, wanted) != Stepper::State::kReady) continue;
      for (Message& message : stepper->Run()) {
        sent_.push_back(message);
        log_.push_back(message);
      }
    }
    ++tick_;
  }

  template <class M>
  std::vector<M> Sent(const std::string& channel) const {
    std::vector<M> messages;
    for (const Message& message : log_) {
      if (message.channel == channel) messages.push_back(Decoded<M>(message));
    }
    return messages;
  }
  const std::vector<Message>& log() const { return log_; }
  int32_t tick() const { return tick_; }
  int64_t NumRejected() const {
    int64_t count = 0;
    for (const auto& stepper : steppers_) {
      for (const auto& [channel, n] : stepper->num_rejected()) count += n;
    }
    return count;
  }

 private:
  template <class Maker>
  void Add(const char* name, const char* role, Maker maker,
           const Deployment& deployment) {
    Stepper::Params params;
    params.name = name;
    params.truth_role = role;
    params.sender = static_cast<int32_t>(steppers_.size()) + 1;
    steppers_.push_back(std::make_unique<Stepper>(params));
    services_.push_back(maker(*steppers_.back(), deployment));
  }
  template <class M>
  Message Clocks(const char* channel, M message) {
    message.header.tick = tick_;
    return *MessageFromWire(channel, Bus::Encode(message));
  }

  std::vector<std::unique_ptr<Stepper>> steppers_;
  std::vector<std::unique_ptr<Service>> services_;
  std::vector<Message> sent_;
  std::vector<Message> log_;
  int32_t lost_key_frame_ = -1;
  int32_t tick_ = 0;
};

// The world: parts on a stage, and a right hand that grasps.
class World {
 public:
  explicit World(const ShippedTask& task) : task_(task), stage_(task) {}

  truth_poses_t Truth(int64_t utime) const {
    truth_poses_t truth{};
    truth.header.utime = utime;
    const auto add = [&](const std::string& name, const Isometry3d& X_WB) {
      body_pose_t& body = truth.bodies.emplace_back();
      body.name = name;
      body.pose_world_body = PoseToMessage(X_WB);
    };
    for (const Track& part : stage_.AllTracked().tracks) {
      add(part.name, part.X_WO);
    }
    for (const auto& hand : task_.layout.hands) {
      const bool is_right = hand.name == "hand_right";
      const Isometry3d X_WG =
          is_right ? X_WG_ : Isometry3d(Translation3d(hand.p_WG_rest));
      const double half = (is_right ? opening_ : 0.1) / 2;
      TruthPoses boxes;
      AddHand(hand.type, hand.name, X_WG, 2 * half, boxes);
      for (const auto& [name, X_WB] : boxes.poses) add(name, X_WB);
    }
    truth.num_bodies = static_cast<int32_t>(truth.bodies.size());
    return truth;
  }

  void Grasp(const std::string& part) {
    const cell::Grasp& grasp = task_.parts.Find(part)->grasps.front();
    X_WG_ = stage_.PoseOf(part) * grasp.X_OG;
    opening_ = grasp.width;
  }
  void Withdraw() {
    X_WG_ = Translation3d(0.6, -0.3, 0.4);
    opening_ = 0.1;
  }
  Stage& stage() { return stage_; }

 private:
  const ShippedTask& task_;
  Stage stage_;
  Isometry3d X_WG_ = Isometry3d(Translation3d(0.6, -0.3, 0.4));
  double opening_ = 0.1;
};

class WatchingServicesTest : public testing::Test {
 protected:
  void Begin() {
    episode_t episode{};
    episode.header.utime = now();
    episode.phase = episode_t::START;
    episode.agent = "person";
    episode.goal = "assembled";
    watchers_->Tick(std::pair{"EPISODE", episode},
                    std::pair{"TRUTH_POSES", world_->Truth(now())});
  }
  void RunFor(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      watchers_->Tick(std::pair{"TRUTH_POSES", world_->Truth(now())});
    }
  }
  void PutBy(const std::string& part, const std::function<void()>& move) {
    world_->Grasp(part);
    RunFor(62);
    world_->stage().Lift(part, 0.2);
    world_->Grasp(part);
    RunFor(62);
    move();
    world_->Grasp(part);
    RunFor(62);
    world_->Withdraw();
    RunFor(62);
  }
  void Demonstrate() {
    Begin();
    RunFor(62);
    PutBy("round_peg_1",
          [&] { world_->stage().Seat("round_peg_1", "base.round_1"); });
    PutBy("shaft", [&] { world_->stage().Seat("shaft", "base.shaft"); });
    PutBy("shaft", [&] { world_->stage().StandAt("shaft", 0.1, -0.5); });
    PutBy("head", [&] { world_->stage().StandAt("head", 0.25, -0.5); });
  }
  int64_t now() const { return watchers_->tick() * kTickUs; }
  /// The last that was reported of the part being in hole round_1.
  int LastOfFirstHole(const std::string& part) const {
    const auto last = watchers_->Sent<predicates_t>("PREDICATES").back();
    const auto it =
        std::ranges::find_if(last.literals, [&](const literal_t& literal) {
          return literal.predicate == "PegInHole" &&
                 literal.arguments ==
                     std::vector<std::string>{part, "base.round_1"};
        });
    return it == last.literals.end() ? -1 : it->value;
  }

  ShippedTask task_;
  std::optional<World> world_{std::in_place, task_};
  std::unique_ptr<Watchers> watchers_ = std::make_unique<Watchers>();
};

TEST_F(WatchingServicesTest, TracksComeAtCameraRate) {
  Begin();
  RunFor(120);
  const auto tracks = watchers_->Sent<tracks_t>("TRACKS");
  ASSERT_THAT(tracks, SizeIs(11));
  for (const tracks_t& t : tracks) {
    EXPECT_EQ(t.header.tick % 12, 0);
    EXPECT_EQ(t.header.utime, t.header.tick * kTickUs);
    EXPECT_EQ(t.num_tracks, 12);
  }
}

TEST_F(WatchingServicesTest, ManipulationsAreRecognised) {
  Demonstrate();
  std::vector<std::string> seen;
  for (const recognised_action_t& action :
       watchers_->Sent<recognised_action_t>("ACTION")) {
    EXPECT_EQ(action.index, static_cast<int64_t>(seen.size()));
    EXPECT_THAT(action.hands, ElementsAre("hand_right"));
    std::string text =
        std::to_string(action.kind) + " " + action.part + " " + action.name;
    for (const std::string& argument : action.arguments) text += " " + argument;
    seen.push_back(text);
  }
  EXPECT_THAT(
      seen, ElementsAre("0 round_peg_1 PlaceRoundPeg round_peg_1 base.round_1",
                        "0 shaft PlaceRoundPeg shaft base.shaft",
                        "1 shaft PlaceRoundPeg shaft base.shaft", "2 head "));
  EXPECT_EQ(watchers_->NumRejected(), 0);
}

TEST_F(WatchingServicesTest, EveryKeyFrameHasItsPredicatesInTheSameOrder) {
  Demonstrate();
  const auto frames = watchers_->Sent<key_frame_t>("KEY_FRAME");
  const auto predicates = watchers_->Sent<predicates_t>("PREDICATES");
  ASSERT_EQ(predicates.size(), frames.size());
  EXPECT_GT(frames.size(), 10u);
  for (size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].index, static_cast<int64_t>(i));
    EXPECT_EQ(predicates[i].key_frame, frames[i].index);
    EXPECT_EQ(predicates[i].header.utime, frames[i].header.utime);
    EXPECT_EQ(predicates[i].header.tick, frames[i].header.tick + 1);
    for (const literal_t& literal : predicates[i].literals) {
      EXPECT_NE(literal.value, literal_t::UNKNOWN) << literal.predicate;
    }
  }
}

TEST_F(WatchingServicesTest, PredicatesAreSensedAgainOnRequest) {
  const auto ask = [&] {
    watchers_->Tick(std::pair{"TRUTH_POSES", world_->Truth(now())},
                    std::pair{"SENSE_REQUEST", sense_request_t{}});
  };
  Begin();
  ask();  // nothing has been seen yet
  EXPECT_THAT(watchers_->Sent<predicates_t>("PREDICATES"), IsEmpty());
  RunFor(62);
  ASSERT_THAT(watchers_->Sent<predicates_t>("PREDICATES"), SizeIs(1));
  // What changes no relation makes no key frame, but may be asked for.
  world_->stage().LieAt("shaft", 0.3, -0.2);
  RunFor(25);
  const size_t num_before = watchers_->Sent<predicates_t>("PREDICATES").size();
  ask();
  const auto predicates = watchers_->Sent<predicates_t>("PREDICATES");
  ASSERT_EQ(predicates.size(), num_before + 1);
  const predicates_t& last = predicates.back();
  EXPECT_EQ(last.key_frame,
            watchers_->Sent<key_frame_t>("KEY_FRAME").back().index);
  EXPECT_EQ(last.header.utime,
            watchers_->Sent<tracks_t>("TRACKS").back().header.utime);
  bool is_lying = false;
  for (const literal_t& literal : last.literals) {
    EXPECT_NE(literal.predicate, "Held");
    EXPECT_NE(literal.predicate, "Reachable");
    if (literal.predicate == "Horizontal" && literal.arguments[0] == "shaft") {
      is_lying = literal.value == literal_t::TRUE_;
    }
  }
  EXPECT_TRUE(is_lying);
}

// Only predicate_estimator knows the noise; its input is the same.
TEST_F(WatchingServicesTest, ASeatThatNoiseLeavesOpenIsReportedAsUnknown) {
  Demonstrate();
  EXPECT_EQ(LastOfFirstHole("round_peg_1"), literal_t::TRUE_);
  const auto files = NewTestFolder();
  Deployment deployment = ShippedDeployment();
  std::filesystem::copy(deployment.config_dir, files,
                        std::filesystem::copy_options::recursive);
  std::ofstream(files / "predicate_estimator.yaml")
      << "pose_noise_mm: 2\npose_noise_deg: 1\n";
  deployment.config_dir = files;
  watchers_ = std::make_unique<Watchers>(deployment);
  world_.emplace(task_);
  Demonstrate();
  EXPECT_EQ(LastOfFirstHole("round_peg_1"), literal_t::UNKNOWN);
  EXPECT_EQ(LastOfFirstHole("round_peg_2"), literal_t::FALSE_)
      << "it touches nothing that has a seat";
  std::filesystem::remove_all(files);
}

TEST_F(WatchingServicesTest, ANewEpisodeStartsWithoutTheLast) {
  Demonstrate();
  const size_t num_before = watchers_->Sent<key_frame_t>("KEY_FRAME").size();
  world_->stage().StandAt("round_peg_1", 0.4, -0.5);
  Begin();
  RunFor(62);
  const auto frames = watchers_->Sent<key_frame_t>("KEY_FRAME");
  ASSERT_EQ(frames.size(), num_before + 1);
  EXPECT_EQ(frames.back().index, 0);
  PutBy("round_peg_1",
        [&] { world_->stage().Seat("round_peg_1", "base.round_2"); });
  const auto actions = watchers_->Sent<recognised_action_t>("ACTION");
  EXPECT_EQ(actions.back().index, 0);
  EXPECT_THAT(actions.back().arguments,
              ElementsAre("round_peg_1", "base.round_2"));
}

TEST_F(WatchingServicesTest, SameInputsGiveTheSameBytes) {
  std::vector<std::vector<Message>> logs;
  for (int run = 0; run < 2; ++run) {
    watchers_ = std::make_unique<Watchers>();
    world_.emplace(task_);
    Demonstrate();
    logs.push_back(watchers_->log());
  }
  ASSERT_EQ(logs[0].size(), logs[1].size());
  for (size_t i = 0; i < logs[0].size(); ++i) {
    EXPECT_EQ(logs[0][i].channel, logs[1][i].channel);
    EXPECT_EQ(logs[0][i].tick, logs[1][i].tick);
    ASSERT_EQ(*logs[0][i].bytes, *logs[1][i].bytes);
  }
}

// Whichever key frame is lost, by all: the next one has all relations. The
// shaft is placed and taken out again; without the key frame between, that is
// one unknown manipulation of it.
TEST_F(WatchingServicesTest, ALostKeyFrameLeavesNoPlacementUnreported) {
  Demonstrate();
  const size_t num_frames = watchers_->Sent<key_frame_t>("KEY_FRAME").size();
  for (size_t lost = 0; lost < num_frames; ++lost) {
    watchers_ = std::make_unique<Watchers>();
    watchers_->AddPlanner();
    watchers_->LoseKeyFrame(static_cast<int32_t>(lost));
    world_.emplace(task_);
    Demonstrate();
    episode_t end{};
    end.phase = episode_t::END;
    watchers_->Tick(std::pair{"EPISODE", end});
    RunFor(100);
    std::string told;
    for (const recognised_action_t& action :
         watchers_->Sent<recognised_action_t>("ACTION")) {
      told += action.part + "\n";
    }
    for (const alert_t& alert : watchers_->Sent<alert_t>("ALERT")) {
      if (alert.cause == alert_t::UNSEEN) told += alert.text + "\n";
    }
    for (const char* part : {"round_peg_1", "shaft"}) {
      EXPECT_THAT(told, HasSubstr(part)) << "key frame " << lost << " is lost";
    }
  }
}

TEST_F(WatchingServicesTest, BadMessagesAreCountedAndChangeNothing) {
  Demonstrate();
  const size_t num_before = watchers_->log().size();
  truth_poses_t truth = world_->Truth(now());
  truth.bodies[0].pose_world_body.position[0] =
      std::numeric_limits<double>::quiet_NaN();
  tracks_t tracks = watchers_->Sent<tracks_t>("TRACKS").back();
  tracks.tracks[0].name = "nobody";
  key_frame_t frame = watchers_->Sent<key_frame_t>("KEY_FRAME").back();
  frame.relations[0].relation = 5;
  episode_t episode{};
  episode.phase = 7;
  watchers_->Tick(std::pair{"TRUTH_POSES", truth}, std::pair{"TRACKS", tracks},
                  std::pair{"KEY_FRAME", frame}, std::pair{"EPISODE", episode});
  // truth 1, tracks 2, key frame 2, episode 4
  EXPECT_EQ(watchers_->NumRejected(), 9);
  size_t num_status = 0;
  for (size_t i = num_before; i < watchers_->log().size(); ++i) {
    num_status += watchers_->log()[i].channel == "STATUS";
  }
  EXPECT_EQ(watchers_->log().size() - num_before, num_status);
}

TEST_F(WatchingServicesTest, RepeatedAndOldMessagesAreRejected) {
  Demonstrate();
  const auto frames = watchers_->Sent<key_frame_t>("KEY_FRAME");
  const auto tracks = watchers_->Sent<tracks_t>("TRACKS");
  const size_t num_actions =
      watchers_->Sent<recognised_action_t>("ACTION").size();
  watchers_->Tick(std::pair{"KEY_FRAME", frames.back()},
                  std::pair{"TRACKS", tracks[tracks.size() - 2]});
  watchers_->Tick(std::pair{"KEY_FRAME", frames[3]});
  EXPECT_EQ(watchers_->NumRejected(), 3);
  EXPECT_EQ(watchers_->Sent<recognised_action_t>("ACTION").size(), num_actions);
}

TEST_F(WatchingServicesTest, MidRunServicesStartWithoutAnEpisode) {
  RunFor(62);
  EXPECT_THAT(watchers_->Sent<key_frame_t>("KEY_FRAME"), SizeIs(1));
  EXPECT_THAT(watchers_->Sent<predicates_t>("PREDICATES"), SizeIs(1));
  EXPECT_THAT(watchers_->Sent<recognised_action_t>("ACTION"), IsEmpty());
}

TEST(WatchingServices, GroundTruthIsReadByTheIdealTrackerOnly) {
  Stepper::Params params;
  params.name = "tracker";
  Stepper stepper(params);
  EXPECT_THROW(MakeTracker(stepper, ShippedDeployment()), std::logic_error);
}

}  // namespace
}  // namespace cell
