// A run that is interrupted, and records of another run: what is kept, what is said.

#include <graze/bvh/error.h>
#include <graze/engine/cli/output/interruption.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/compare/run/record/place_block.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <atomic>
#include <csignal>

#include "tests/engine/cli/compare/compare_fixture.h"

namespace graze::cli {
namespace {

class CliStop : public CliCompare {
 protected:
  CliStop() {
    options_.resume = directory_.path("run.jsonl");
    std::signal(SIGINT, SIG_DFL);  // who runs the tests may ignore it
  }

  /// graze and one that interrupts the program at this question.
  std::vector<EngineEntry> interrupted_at(int question) {
    asked_ = 0;
    return graze_and(compare::make_watched_engine("other", [this, question] {
      if (++asked_ == question) std::raise(SIGINT);
    }));
  }

  /// What a run that is interrupted says; empty if it is not.
  std::string stopped(const std::vector<EngineEntry>& engines) {
    try {
      compare(engines);
    } catch (const Interrupted& stopped) {
      return stopped.what();
    }
    return "";
  }

  /// What a run that is refused says.
  template <typename Refusal>
  std::string refused(const std::vector<EngineEntry>& engines) {
    try {
      compare(engines);
    } catch (const Refusal& refusal) {
      return refusal.what();
    }
    return "";
  }

  /// How many poses the record has.
  std::size_t recorded() const {
    compare::JournalReader file(options_.resume);
    std::size_t count = 0;
    for (std::string line; file.next(line);) {
      const cases::JsonValue tree = cases::parse_json(line, file.place());
      const std::vector<compare::PlaceRecord> block = compare::read_place_block(
          {tree, file.place()}, file.head().engines, count, file.head().places);
      count += block.size();
    }
    return count;
  }

  std::atomic<int> asked_ = 0;
};

TEST_F(CliStop, WhatIsBegunIsFinishedAndTheRestIsDoneLater) {
  options_.threads = 1;
  EXPECT_EQ(stopped(interrupted_at(4)),
            "interrupted: 4 of 12 poses done, go on with --resume " + options_.resume);
  EXPECT_EQ(recorded(), 4u) << "the one of the signal too";
  EXPECT_EQ(stopped(interrupted_at(3)),
            "interrupted: 7 of 12 poses done, go on with --resume " + options_.resume);
  EXPECT_EQ(compare(interrupted_at(1000)), ExitCode::Answered);
  EXPECT_EQ(asked_, 5) << "the rest";
  EXPECT_EQ(recorded(), 12u);
  const std::string in_parts = out_;
  options_.resume.clear();
  EXPECT_EQ(compare(interrupted_at(1000)), ExitCode::Answered);
  EXPECT_EQ(out_.substr(0, out_.find("  engine")), in_parts.substr(0, in_parts.find("  engine")));
}

TEST_F(CliStop, AllThreadsFinishWhatTheyHaveBegun) {
  options_.threads = 3;
  options_.random = 60;
  const std::string said = stopped(interrupted_at(10));
  ASSERT_NE(said, "");
  const std::size_t done = recorded();
  EXPECT_EQ(said.find("interrupted: " + std::to_string(done) + " of 60 poses done"), 0u) << said;
  EXPECT_GE(done, 10u);
  EXPECT_LE(done, 30u) << "those that were begun ahead of their turn";
  EXPECT_EQ(compare(interrupted_at(1000)), ExitCode::Answered);
  EXPECT_EQ(asked_, 60 - static_cast<int>(done));
}

/// What is to be done at the end of the program is done at the second signal, not forgotten.
TEST_F(CliStop, ASecondSignalDoesWhatItDidBefore) {
  static volatile std::sig_atomic_t ends = 0;
  std::signal(SIGINT, [](int) { ends = ends + 1; });
  {
    const Interruption interruption;
    std::raise(SIGINT);
    EXPECT_TRUE(Interruption::is_requested());
    EXPECT_EQ(ends, 0);
    std::raise(SIGINT);
    EXPECT_EQ(ends, 1);
  }
  std::raise(SIGINT);
  EXPECT_EQ(ends, 2) << "and afterwards";
  std::signal(SIGINT, SIG_DFL);
}

TEST_F(CliStop, TheLastPoseIsTooLateToStop) {
  options_.threads = 1;
  EXPECT_EQ(stopped(interrupted_at(12)), "");
  EXPECT_NE(out_.find("12 poses"), out_.npos);
}

TEST_F(CliStop, ARecordOfSomethingElseSaysWhatDiffers) {
  options_.query = "within";
  options_.clearance = 0.5;
  options_.save = directory_.path("base");
  const std::string base = options_.save;
  options_.resume.clear();
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  options_.save.clear();
  options_.against = base;
  const std::string place = "--against: " + base + " is a record of something else: ";
  const auto difference = [&] { return refused<UsageError>(with_wrong_fcl()); };
  options_.clearance = 0.25;
  EXPECT_EQ(difference(), place + "question within 0.5 m, not within 0.25 m");
  options_.query = "any";
  options_.clearance = -1;
  EXPECT_EQ(difference(), place + "question within 0.5 m, not any");
  options_.query = "within";
  options_.clearance = 0.5;
  options_.seed = 7;
  EXPECT_EQ(difference(), place + "poses of B random 12, seed 1, not random 12, seed 7");
  options_.seed.reset();
  options_.random = 11;
  EXPECT_EQ(difference(),
            place + "poses of B random 12, seed 1, not random 11, seed 1; 12 poses, not 11");
  options_.random = 12;
  directory_.write("b.off", off_of(tests::make_box({0.5, 0.5, 0.75})));
  EXPECT_EQ(difference().find(place + "not the same mesh B"), 0u) << difference();
  directory_.write("b.off", off_of(tests::make_box({0.5, 0.5, 0.5})));
  EXPECT_EQ(difference(), "") << "the same again";
  const std::string rest = ",\"key\":\"x\",\"asked\":[],\"engines\":[],";
  directory_.write("base", sealed_again("{\"graze_case_comparison\":2" + rest + "\"cases\":1}\n"));
  EXPECT_EQ(difference(), place + "it is of cases, not of two meshes");
  directory_.write("base", sealed_again("{\"graze_comparison\":1" + rest + "\"poses\":12}\n"));
  EXPECT_EQ(refused<CaseError>(with_wrong_fcl()),
            base + ":1:1: /graze_comparison: is version 1; this program reads 2");
}

TEST_F(CliStop, APoseThatStandsTwiceIsRefused) {
  options_.save = directory_.path("base");
  options_.resume.clear();
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  const std::string text = read("base");
  const std::size_t second = text.find('\n') + 1;
  directory_.write("base", text + text.substr(second));
  options_.resume = options_.save;
  options_.save.clear();
  EXPECT_EQ(refused<CaseError>(with_wrong_fcl()),
            options_.resume + ":3:1: /poses/0: is 0 where 12 should stand");
}

}  // namespace
}  // namespace graze::cli
