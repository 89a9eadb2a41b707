#include "services/cell/evaluations/taught_episodes.h"

#include <gmock/gmock.h>

#include <optional>
#include <string>

#include "cell/episode_t.hpp"
#include "cell/execution_t.hpp"
#include "cell/truth_action_t.hpp"
#include "tests/unit/cell/fed_messages.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace cli;
namespace {

class TaughtEpisodesTest : public testing::Test {
 protected:
  template <class M>
  void Put(const std::string& channel, const M& message) {
    episodes_.Put(LoggedMessage(channel, message, utime_));
  }
  void Episode(int8_t phase) {
    episode_t message{};
    message.phase = phase;
    Put("EPISODE", message);
  }
  void Ask(const std::string& text, int8_t state = execution_t::STUCK) {
    execution_t message{};
    message.state = state;
    message.text = text;
    Put("EXECUTION", message);
  }
  /// Half a second in which nothing moves.
  void Rest() {
    for (int i = 0; i < 5; ++i) {
      utime_ += 100'000;
      Put("TRUTH_POSES", TruthOf(*stage_, task_.parts));
    }
  }
  nlohmann::json Row(size_t episode) const {
    return episodes_.Rows().at(episode);
  }

  ShippedTask task_;
  std::optional<Stage> stage_{std::in_place, task_};
  SuccessCriterion success_ = SuccessCriterion::Load(ShippedDeployment());
  TaughtEpisodes episodes_{task_, success_};
  int64_t utime_ = 0;
};

TEST_F(TaughtEpisodesTest, EachEpisodeHasItsOwnQuestionsAndScore) {
  Episode(episode_t::START);
  Ask("please show me this");
  Put("TRUTH_ACTIONS", truth_action_t{});
  Ask("", execution_t::RUNNING);
  Ask("please show me that");
  Rest();
  stage_->SeatAll();
  Rest();
  Episode(episode_t::END);
  stage_.emplace(task_);
  Rest();  // the parts are laid out anew
  Episode(episode_t::START);
  Rest();
  Episode(episode_t::END);
  ASSERT_EQ(episodes_.Rows().size(), 2U);
  EXPECT_EQ(Row(0).at("questions"),
            (nlohmann::json{"please show me this", "please show me that"}));
  EXPECT_EQ(Row(0).at("demonstrations"), 1);
  EXPECT_EQ(Row(0).at("complete"), true);
  EXPECT_EQ(Row(0).at("seconds"), 1.0);
  EXPECT_TRUE(Row(1).at("questions").empty());
  EXPECT_EQ(Row(1).at("demonstrations"), 0);
  EXPECT_EQ(Row(1).at("complete"), false);
}

TEST_F(TaughtEpisodesTest, AQuestionThatIsRepeatedIsOne) {
  Episode(episode_t::START);
  Ask("please show me this");
  Ask("please show me this");
  Rest();
  EXPECT_EQ(Row(0).at("questions").size(), 1U);
}

TEST(IsTaughtFrom, NeedsEveryLaterEpisodeCompleteAndWithoutQuestions) {
  const nlohmann::json asked = {{"questions", {"?"}}, {"complete", true}};
  const nlohmann::json alone = {{"questions", nlohmann::json::array()},
                                {"complete", true}};
  const nlohmann::json failed = {{"questions", nlohmann::json::array()},
                                 {"complete", false}};
  EXPECT_TRUE(IsTaughtFrom({asked, alone}, 1));
  EXPECT_FALSE(IsTaughtFrom({asked, alone}, 0));
  EXPECT_FALSE(IsTaughtFrom({asked, alone, asked}, 1));
  EXPECT_FALSE(IsTaughtFrom({asked, failed}, 1));
  EXPECT_FALSE(IsTaughtFrom({asked, alone}, 2)) << "there was no such episode";
}

}  // namespace
}  // namespace cell
