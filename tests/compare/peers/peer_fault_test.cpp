// Engines in processes that die, hang or write what is no answer: each becomes an engine error of
// theirs, nothing of it reaches this process, and none of their processes is left behind.

#include <graze/engine/cases/to_case.h>
#include <graze/engine/compare/peers/process/process_engine.h>
#include <graze/engine/compare/run/comparison.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/mesh/distance.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <mutex>
#include <string>

#include "tests/compare/each_record.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::compare {
namespace {

std::size_t open_files() {
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {}));
}

/// graze and a planted peer about two boxes that are apart.
class PeerFaults : public testing::Test {
 protected:
  PeerFaults() { aside_.translation().x() = 3; }

  static std::vector<EngineEntry> graze_and(const std::string& fault, double timeout = 20) {
    std::vector<EngineEntry> engines;
    engines.push_back({"graze", make_graze_engine()});
    engines.push_back({"odd", make_process_engine({.name = "odd",
                                                   .command = {GRAZE_PLANTED_PEER, "odd", fault},
                                                   .timeout = ChildProcess::Seconds(timeout),
                                                   .longest_line = 1 << 20})});
    return engines;
  }

  Case query(Ask ask = Ask::Any) const {
    Case query = to_case({box_}, {box_, aside_}, false);
    query.ask = ask;
    query.answer.reset();
    return query;
  }

  /// What try_case() holds against the peer, or "silent".
  std::string truth_of(const std::string& fault, Ask ask = Ask::Any, double timeout = 20) const {
    const std::vector<Testimony> all = try_case(query(ask), graze_and(fault, timeout));
    EXPECT_EQ(all.front().judgement.verdict, Verdict::Right) << "graze";
    if (all.size() == 1) return "silent";
    const Judgement& judgement = all.back().judgement;
    if (judgement.verdict == Verdict::Right) return "right";
    EXPECT_EQ(judgement.verdict, Verdict::Wrong);
    EXPECT_EQ(judgement.error_class, ErrorClass::EngineError);
    return judgement.truth;
  }

  void expect_nothing_left(std::size_t files) const {
    EXPECT_EQ(open_files(), files);
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
    EXPECT_EQ(errno, ECHILD);
  }

  Mesh box_ = tests::make_box({1, 1, 1});
  Pose aside_ = Pose::Identity();
};

TEST_F(PeerFaults, AreEngineErrorsThatSayWhatHappened) {
  const std::size_t files = open_files();
  EXPECT_EQ(truth_of("dies at once"), "engine error: died of SIGSEGV");
  EXPECT_EQ(truth_of("dies loading"), "engine error: died of SIGSEGV");
  EXPECT_EQ(truth_of("dies"), "engine error: died of SIGSEGV");
  EXPECT_EQ(truth_of("ends"), "engine error: ended with exit code 3; it said: out of paint");
  EXPECT_EQ(truth_of("error"), "engine error: out of its depth");
  EXPECT_EQ(truth_of("no end"), "engine error: wrote a line of more than 1048576 bytes");
  EXPECT_EQ(truth_of("another engine"), "engine error: says that it is somebody, not odd");
  const auto expect_start = [](const std::string& truth, const std::string& start) {
    EXPECT_EQ(truth.substr(0, start.size()), start);
  };
  const std::string unreadable = "engine error: what it wrote cannot be read: ";
  expect_start(truth_of("garbage"), unreadable + "its answer:1: not JSON");
  expect_start(truth_of("no number", Ask::Distance), unreadable + "its answer:1: /answer/distance");
  expect_start(truth_of("null", Ask::Distance),
               unreadable + "its answer:1: /answer/distance: is null");
  expect_start(truth_of("another part"), unreadable + "its answer:1: /answer: unknown key");
  expect_start(truth_of("none", Ask::FirstContact), unreadable + "its answer:1: /answer");
  EXPECT_EQ(truth_of("dies", Ask::Free), "engine error: died of SIGSEGV");
  expect_start(truth_of("another number"), unreadable + "its answer:1: /id: is not that of");
  expect_start(truth_of("later protocol"),
               unreadable + "its first line:1: /graze_peer: is version 2");
  expect_nothing_left(files);
}

TEST_F(PeerFaults, AnEngineThatHangsIsEndedInTime) {
  const std::size_t files = open_files();
  const auto start = std::chrono::steady_clock::now();
  for (const char* fault : {"hangs", "hangs loading", "says nothing"})
    EXPECT_EQ(truth_of(fault, Ask::Any, 0.125), "engine error: gave no answer in 0.125 s") << fault;
  EXPECT_EQ(truth_of("hangs", Ask::FirstContact, 0.125), "engine error: gave no answer in 0.125 s");
  EXPECT_EQ(truth_of("closes", Ask::Any, 20), "engine error: closed its pipe");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(15));
  expect_nothing_left(files);
}

TEST_F(PeerFaults, RefusalsAndNoiseAreNoErrors) {
  EXPECT_EQ(truth_of("refuses"), "silent");
  EXPECT_EQ(truth_of("unsupported"), "silent");
  EXPECT_EQ(truth_of("none"), "right");
  EXPECT_EQ(truth_of("noise"), "right") << "a full pipe of standard error blocks nobody";
}

/// Whatever it is asked, by however many threads, a process that died is replaced.
TEST_F(PeerFaults, StopNoComparison) {
  const std::size_t files = open_files();
  const ComparisonJob job{.a = CaseMesh(box_, Pose::Identity()),
                          .b = CaseMesh(box_, aside_),
                          .poses_b = pose_list(std::vector<Pose>(12, aside_)),
                          .question = {}};
  for (const char* fault : {"dies", "wrong", "answers twice"}) {
    std::size_t wrong = 0;
    std::size_t errors = 0;
    std::size_t unconfirmed = 0;
    {
      const std::vector<EngineEntry> engines = graze_and(fault);
      run_comparison(job, engines, {.end = job.places(), .threads = 4},
                     each_record<PlaceRecord>([&](const PlaceRecord& record) {
                       ASSERT_EQ(record.answers.size(), 2u);
                       EXPECT_FALSE(record.answers.front().is_wrong());
                       const Judgement& judgement = record.answers.back().judgement;
                       wrong += record.answers.back().is_wrong();
                       errors += record.answers.back().is_wrong() &&
                                 judgement.error_class == ErrorClass::EngineError;
                       unconfirmed += judgement.verdict == Verdict::NotConfirmed;
                     }));
    }
    const bool is_steady = std::string(fault) != "answers twice";
    EXPECT_EQ(wrong, is_steady ? 12u : 0u) << fault;
    EXPECT_EQ(errors, std::string(fault) == "dies" ? 12u : 0u) << fault;
    if (!is_steady) {
      EXPECT_GT(unconfirmed, 0u) << "the second question of each process";
    }
    expect_nothing_left(files);
  }
}

/// Right in a process of its own, and wrong in one that was asked before: that is counted, and not
/// held against it.
TEST_F(PeerFaults, WhatIsNotConfirmedIsNoError) {
  const std::vector<EngineEntry> engines = graze_and("forgets");
  const std::vector<Testimony> all = try_case(query(), engines);  // asks twice
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all.back().judgement.verdict, Verdict::NotConfirmed);
  EXPECT_EQ(all.back().answer.says, true);
  EXPECT_NE(all.back().judgement.truth.find("; alone it says: no"), std::string::npos)
      << all.back().judgement.truth;
  const std::vector<Testimony> steady = try_case(query(), graze_and("wrong"));
  EXPECT_EQ(steady.back().judgement.verdict, Verdict::Wrong);
  EXPECT_EQ(steady.back().judgement.error_class, ErrorClass::Real);
}

TEST_F(PeerFaults, AProgramThatIsNotThereIsNamed) {
  const std::string name = "/nowhere/at-all/graze-peer";
  std::vector<EngineEntry> engines;
  engines.push_back({"graze", make_graze_engine()});
  engines.push_back(
      {"fcl", make_process_engine({.name = "fcl", .command = {name, "fcl"}, .timeout = {}})});
  try {
    try_case(query(), engines);
    FAIL();
  } catch (const EngineMissingError& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, name.size()), name) << error.what();
  }
}

}  // namespace
}  // namespace graze::compare
