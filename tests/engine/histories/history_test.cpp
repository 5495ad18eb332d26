// Law 9 over random histories: worlds against every body asked about every other.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/engine/histories/parts_plan.h"
#include "tests/engine/histories/player.h"

namespace graze::tests {
namespace {

/// Bodies in one point, and of all sizes in one place, go deep into each other: the ways out are
/// dear.
bool is_dear(Setting setting) {
  return setting == Setting::Sizes || setting == Setting::OnePoint;
}

Sights expect_no_failure(const History& history, const std::string& name) {
  Sights sights;
  const std::optional<Failure> failure = play(history, &sights);
  if (failure) {
    ADD_FAILURE() << "operation " << failure->at << ": " << failure->what;
    keep(shrunk(history), name);
  }
  return sights;
}

class Histories : public testing::TestWithParam<Setting> {};

TEST_P(Histories, EqualBruteForce) {
  const Setting setting = GetParam();
  const std::size_t count = is_dear(setting) ? 250 : 1500;
  const Sights sights = expect_no_failure(random_history(setting, 1, count), name_of(setting));
  EXPECT_GT(sights.updates, count / 15);
  // What has parts is large and touches long, and every fourth operation is about a part.
  const std::size_t seldom = setting == Setting::Parts ? 2 : 1;
  EXPECT_GT(sights.begun, count / 15 / seldom);
  EXPECT_GT(sights.ended, count / 30 / seldom);
  EXPECT_GT(sights.contacts, count / 8);
  EXPECT_GT(sights.answers, count / 20);
  EXPECT_GT(sights.pairs_at_rest, count);
  if (setting == Setting::Parts) {
    EXPECT_GT(sights.part_contacts, count / 4);
    EXPECT_GT(sights.part_first_contacts, count / 30);
  }
  if (setting == Setting::Parts || setting == Setting::Terrains) {
    EXPECT_GT(sights.begun_near, count / 60);
    EXPECT_GT(sights.contacts_apart, count / 30);
    EXPECT_GT(sights.casts, count / 40);
    EXPECT_GT(sights.later_first_contacts, count / 60);
  }
}

class HistoriesSlow : public testing::TestWithParam<Setting> {};

TEST_P(HistoriesSlow, OfAHundredThousandOperationsEqualBruteForce) {
  const Setting setting = GetParam();
  // A fresh world now and then: in one that is old few things happen for the first time.
  const std::size_t count = is_dear(setting) ? 1000 : 5000;
  Sights all;
  const char* more = std::getenv("GRAZE_HISTORY_SEEDS");
  const std::uint64_t seeds = more == nullptr ? 20 : std::strtoull(more, nullptr, 10);
  ASSERT_GT(seeds, 0u) << "GRAZE_HISTORY_SEEDS is no positive number";
  for (std::uint64_t seed = 1; seed <= seeds && !HasFailure(); ++seed) {
    const Sights sights = expect_no_failure(random_history(setting, 1000 + seed, count),
                                            std::string(name_of(setting)) + "-slow");
    all.pairs_apart += sights.pairs_apart, all.restored += sights.restored;
    all.answers += sights.answers;
  }
  EXPECT_GT(all.pairs_apart, seeds * count / 2000);
  EXPECT_GT(all.restored, seeds * count / 1000);
  EXPECT_GT(all.answers, seeds * count / 20);
}

std::string name_of_test(const testing::TestParamInfo<Setting>& info) {
  return name_of(info.param);
}
INSTANTIATE_TEST_SUITE_P(In, Histories, testing::ValuesIn(kSettings), name_of_test);
INSTANTIATE_TEST_SUITE_P(In, HistoriesSlow, testing::ValuesIn(kSettings), name_of_test);

TEST(HistoryText, IsReadBackAsItWas) {
  for (const Setting setting : kSettings) {
    const History history = random_history(setting, 5, 2000);
    std::stringstream text, again;
    write_history(history, text);
    const History back = read_history(text);
    write_history(back, again);
    EXPECT_EQ(back.operations.size(), history.operations.size());
    EXPECT_EQ(again.str(), text.str());
    for (std::size_t i = 0; i < history.operations.size(); ++i) {
      const Operation &s = history.operations[i], &t = back.operations[i];
      ASSERT_EQ(s.verb, t.verb);
      ASSERT_EQ(s.body, t.body);
      const bool has_pose = s.verb == Verb::Add || s.verb == Verb::Move || s.verb == Verb::MoveToo;
      if (has_pose) {
        ASSERT_EQ(s.pose.matrix(), t.pose.matrix());
      }
    }
  }
}

TEST(HistoryText, RefusesWhatItDoesNotKnowAndNamesTheLine) {
  const auto what = [](const std::string& text) -> std::string {
    std::istringstream in(text);
    try {
      read_history(in);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(what("graze_history 2 crowd\n").find("line 1"), std::string::npos);
  EXPECT_NE(what("graze_history 1 crowd\nupdate\nfly 3\n").find("line 3"), std::string::npos);
  EXPECT_NE(what("graze_history 1 crowd\nremove\n").find("line 2"), std::string::npos);
  EXPECT_NE(what("graze_history 1 crowd\nremove 1x\n").find("'1x'"), std::string::npos);
  EXPECT_NE(what("graze_history 1 crowd\nupdate now\n").find("'now'"), std::string::npos);
  EXPECT_EQ(what("graze_history 1 crowd\n# a word\n\nupdate\n"), "");
}

/// A world that does not listen is found out, and what is left of the history says why.
TEST(HistoryShrink, LeavesWhatAFailureNeeds) {
  for (const Fault fault : {Fault::DeafToFilters, Fault::DeafToShapes, Fault::DeafToSleep,
                            Fault::DeafToParts, Fault::DeafToMargins, Fault::DeafToDetection}) {
    const bool is_of_parts = fault >= Fault::DeafToParts;
    const Setting setting = is_of_parts ? Setting::Parts : Setting::Lattice;
    const History history = random_history(setting, is_of_parts ? 6 : 2, is_of_parts ? 300 : 1500);
    ASSERT_FALSE(play(history));
    ASSERT_TRUE(play(history, nullptr, fault));
    const History least = shrunk(history, fault);
    EXPECT_TRUE(play(least, nullptr, fault));
    EXPECT_FALSE(play(least));
    EXPECT_LE(least.operations.size(), 6u);
    EXPECT_GE(least.operations.size(), 3u);
    const Verb guilty = fault == Fault::DeafToFilters   ? Verb::SetFilter
                        : fault == Fault::DeafToShapes  ? Verb::SetShape
                        : fault == Fault::DeafToMargins ? Verb::SetMargin
                        : fault == Fault::DeafToSleep   ? Verb::Sleep
                                                        : Verb::SetDetection;
    EXPECT_TRUE(
        std::any_of(least.operations.begin(), least.operations.end(), [&](const Operation& o) {
          return fault == Fault::DeafToParts ? is_about_a_part(o.verb) : o.verb == guilty;
        }));
    const std::string path = keep(least, "history-on-trial");
    std::ifstream in(path);
    EXPECT_TRUE(play(read_history(in), nullptr, fault));
    std::filesystem::remove(path);
  }
}

/// What once failed, for ever.
TEST(HistoriesKept, DoNotFailAgain) {
  int played = 0;
  for (const auto& entry : std::filesystem::directory_iterator(GRAZE_KEPT_HISTORIES_DIR)) {
    std::ifstream in(entry.path());
    const auto failure = play(read_history(in));
    EXPECT_FALSE(failure) << entry.path() << ": " << (failure ? failure->what : "");
    ++played;
  }
  EXPECT_GT(played, 3);
}

/// GRAZE_HISTORY=FILE
TEST(HistoriesKept, PlaysAFile) {
  const char* path = std::getenv("GRAZE_HISTORY");
  if (path == nullptr) GTEST_SKIP() << "GRAZE_HISTORY names no file";
  std::ifstream in(path);
  const auto failure = play(read_history(in));
  if (failure) FAIL() << "operation " << failure->at << ": " << failure->what;
}

}  // namespace
}  // namespace graze::tests
