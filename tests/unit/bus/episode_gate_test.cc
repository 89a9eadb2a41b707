#include "common/bus/episode_gate.h"

#include <gtest/gtest.h>

namespace cell {
namespace {

class EpisodeGateTest : public testing::Test {
 protected:
  std::optional<EpisodeEvent> Receive(int8_t phase, int64_t id,
                                      int64_t utime = 0) {
    episode_t message{};
    message.phase = phase;
    message.id = id;
    message.header.utime = utime;
    return gate_.Update(message);
  }

  EpisodeGate gate_;
};

TEST_F(EpisodeGateTest, AnEpisodeBeginsRunsAndEnds) {
  EXPECT_EQ(Receive(episode_t::START, 1), EpisodeEvent::kBegins);
  EXPECT_EQ(Receive(episode_t::RUNNING, 1), EpisodeEvent::kRuns);
  EXPECT_EQ(Receive(episode_t::RUNNING, 1), EpisodeEvent::kRuns);
  EXPECT_EQ(Receive(episode_t::END, 1), EpisodeEvent::kEnds);
  EXPECT_EQ(Receive(episode_t::START, 2), EpisodeEvent::kBegins);
}

TEST_F(EpisodeGateTest, AServiceThatStartsWithinAnEpisodeJoinsItOnce) {
  EXPECT_EQ(Receive(episode_t::RUNNING, 3), EpisodeEvent::kJoins);
  EXPECT_EQ(Receive(episode_t::RUNNING, 3), EpisodeEvent::kRuns);
  EXPECT_EQ(Receive(episode_t::END, 3), EpisodeEvent::kEnds);
}

TEST_F(EpisodeGateTest, AnIdOfZeroIsJoinedLikeAnyOther) {
  EXPECT_EQ(Receive(episode_t::RUNNING, 0), EpisodeEvent::kJoins);
}

TEST_F(EpisodeGateTest, AnEpisodeWhoseStartWasLostIsJoined) {
  Receive(episode_t::START, 1, 1000);
  EXPECT_EQ(Receive(episode_t::RUNNING, 2, 9000), EpisodeEvent::kJoins);
  EXPECT_EQ(Receive(episode_t::RUNNING, 2, 9000), EpisodeEvent::kRuns);
  EXPECT_FALSE(gate_.IsBefore(999));
}

TEST_F(EpisodeGateTest, AStartBeginsAnEpisodeEvenIfItsIdIsKnown) {
  Receive(episode_t::RUNNING, 1);
  EXPECT_EQ(Receive(episode_t::START, 1), EpisodeEvent::kBegins);
  EXPECT_EQ(Receive(episode_t::START, 1), EpisodeEvent::kBegins);
}

TEST_F(EpisodeGateTest, AServiceThatStartsBetweenEpisodesGetsAnEndFirst) {
  EXPECT_EQ(Receive(episode_t::END, 1), EpisodeEvent::kEnds);
  EXPECT_EQ(Receive(episode_t::START, 2), EpisodeEvent::kBegins);
}

TEST_F(EpisodeGateTest, WhatWasMeasuredBeforeTheStartIsOfAnotherEpisode) {
  EXPECT_FALSE(gate_.IsBefore(0));
  Receive(episode_t::START, 1, 8000);
  EXPECT_TRUE(gate_.IsBefore(7999));
  EXPECT_FALSE(gate_.IsBefore(8000));
  Receive(episode_t::END, 1, 16'000);
  EXPECT_FALSE(gate_.IsBefore(8000));
  Receive(episode_t::START, 2, 24'000);
  EXPECT_TRUE(gate_.IsBefore(23'999));
}

TEST_F(EpisodeGateTest, NothingIsBeforeAnEpisodeThatIsJoined) {
  Receive(episode_t::RUNNING, 1, 50'000);
  EXPECT_FALSE(gate_.IsBefore(0));
}

TEST_F(EpisodeGateTest, AnUnknownPhaseIsNothingAndChangesNothing) {
  Receive(episode_t::START, 1, 8000);
  for (const int phase : {-1, 3, 7, 127, -128}) {
    EXPECT_EQ(Receive(static_cast<int8_t>(phase), 2, 90'000), std::nullopt)
        << phase;
  }
  EXPECT_EQ(Receive(episode_t::RUNNING, 1), EpisodeEvent::kRuns);
  EXPECT_FALSE(gate_.IsBefore(8000));
}

}  // namespace
}  // namespace cell
