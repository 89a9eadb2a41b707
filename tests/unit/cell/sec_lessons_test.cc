// The models that the task ships are those its recordings give.
#include "services/cell/learning/sec_lessons.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "common/actions/sec_models.h"
#include "common/recordings/recording_file.h"
#include "services/cell/learning/speaker.h"
#include "tests/test_folder.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace cli;
namespace {

using testing::HasSubstr;
using testing::SizeIs;

std::vector<Recording> ShippedRecordings() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(
           ShippedDeployment().task_dir / "recordings")) {
    files.push_back(entry.path());
  }
  std::ranges::sort(files);
  std::vector<Recording> recordings;
  for (const auto& file : files) recordings.push_back(LoadRecording(file));
  return recordings;
}

TEST(SecLessons, TheShippedModelsAreLearnedFromTheShippedRecordings) {
  std::stringstream shipped;
  shipped
      << std::ifstream(ShippedDeployment().task_dir / kSecModelsFile).rdbuf();
  std::vector<Recording> recordings = ShippedRecordings();
  SecLessons lessons(ShippedDeployment());
  for (const Recording& recording : recordings) lessons.Attend(recording);
  EXPECT_EQ(lessons.ModelsText(), shipped.str());
  for (const SecLearner::Action& action : lessons.Actions()) {
    EXPECT_TRUE(action.is_named) << action.name;
  }
}

// A smoother gives key frames out later than the tracks that names refer to.
TEST(SecLessons, NamesMeanWhatWasShownAlsoWhenPosesAreSmoothed) {
  Deployment smoothed = ShippedDeployment();
  const auto config_dir = NewTestFolder();
  std::filesystem::copy(smoothed.config_dir, config_dir,
                        std::filesystem::copy_options::recursive);
  std::stringstream text;
  text << std::ifstream(config_dir / "sec_builder.yaml").rdbuf();
  std::string yaml = text.str();
  const std::string key = "pose_noise_mm: 0";
  yaml.replace(yaml.find(key), key.size(), "pose_noise_mm: 1");
  std::ofstream(config_dir / "sec_builder.yaml") << yaml;
  smoothed.config_dir = config_dir;
  SecLessons lessons(smoothed);
  for (const Recording& recording : ShippedRecordings()) {
    lessons.Attend(recording);
  }
  EXPECT_THAT(lessons.Models(), SizeIs(7));
  std::filesystem::remove_all(config_dir);
}

TEST(SecLessons, AFirstShowingIsAllThatIsLearnedOfAName) {
  SecLessons lessons(ShippedDeployment());
  for (const Recording& recording : ShippedRecordings()) {
    lessons.AttendFirstShowings(recording);
  }
  const auto models = lessons.Models();
  EXPECT_THAT(models, SizeIs(7));
  for (const auto& [name, model] : models) {
    EXPECT_EQ(model.NumShown(), 1) << name;
  }
}

TEST(SecLessons, ARecordingOfAnotherTaskOrWithAWrongNameIsRefused) {
  SecLessons lessons(ShippedDeployment());
  Recording recording = ShippedRecordings().back();
  const auto complaint = [&] {
    try {
      lessons.Attend(recording);
    } catch (const RecordingError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  recording.task = "laboratory";
  EXPECT_THAT(complaint(), HasSubstr("of the task laboratory, not cranfield"));
  recording.task = "cranfield";
  recording.spoken.front().utime = 0;
  EXPECT_THAT(complaint(), HasSubstr("nothing was shown before it"));
}

TEST(Speaker, NamesWhatTheCellDoesNotKnow) {
  const ShippedTask task;
  const auto demonstrations = vtb::Demonstrations::FromConfig(
      ShippedDeployment().OfTask("demonstrators.yaml"), task.parts);
  const Speaker speaker(demonstrations, task.parts);
  recognised_action_t action{};
  action.kind = recognised_action_t::UNKNOWN;
  action.part = "shaft";
  const vtb::Script& assembly = demonstrations.scripts.at("assembly");
  EXPECT_EQ(speaker.Answer(action, assembly)->name, "PlaceRoundPeg");
  EXPECT_FALSE(speaker.Answer(action, assembly)->is_undone);
  const auto laid =
      speaker.Answer(action, demonstrations.scripts.at("lay_down"));
  EXPECT_EQ(laid->name, "Raise");
  EXPECT_TRUE(laid->is_undone);
  action.part = "cup";
  EXPECT_FALSE(speaker.Answer(action, assembly));
  action.part = "shaft";
  action.kind = recognised_action_t::FORWARD;
  EXPECT_FALSE(speaker.Answer(action, assembly));
}

}  // namespace
}  // namespace cell
