// As many processes as are worth their loading: quick questions of many threads share one, slow
// ones have one each. A load that has failed is tried again later.

#include <graze/engine/compare/peers/process/process_engine.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/shapes/formula_meshes.h"

namespace graze::compare {
namespace {

namespace fs = std::filesystem;

/// Of this process, by /proc/PID/stat: "PID (NAME) STATE PARENT".
std::size_t child_count() {
  std::size_t count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
    std::ifstream file(entry.path() / "stat");
    std::string line;
    if (!std::getline(file, line)) continue;
    const std::size_t parent = line.rfind(") ");
    if (parent == line.npos) continue;
    count += std::stol(line.substr(parent + 4)) == getpid();
  }
  return count;
}

class PeerLoads : public testing::Test {
 protected:
  std::unique_ptr<LoadedPair> load(const std::string& fault) {
    engine_ = make_process_engine({.name = "odd",
                                   .command = {GRAZE_PLANTED_PEER, "odd", fault},
                                   .timeout = ChildProcess::Seconds(20)});
    return engine_->load(box_, box_);
  }

  static bool says(const LoadedPair& pair) {
    const Pose here = Pose::Identity();
    return pair.answer({Ask::Any, {}}, here, here).value().says.value();
  }

  /// From four threads.
  static void ask(const LoadedPair& pair, int count) {
    std::atomic<int> yes = 0;
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) {
      threads.emplace_back([&] {
        for (int k = 0; k < count; ++k)
          yes += says(pair);
      });
    }
    for (std::thread& thread : threads)
      thread.join();
    EXPECT_EQ(yes, 0);
  }

  Mesh box_ = tests::make_box({1, 1, 1});
  std::unique_ptr<Engine> engine_;
};

TEST_F(PeerLoads, QuickQuestionsShareAProcess) {
  const std::unique_ptr<LoadedPair> pair = load("loads slowly");
  ask(*pair, 25);
  EXPECT_EQ(child_count(), 1u);
}

TEST_F(PeerLoads, SlowQuestionsHaveAProcessForEachThread) {
  const std::unique_ptr<LoadedPair> pair = load("answers slowly");
  ask(*pair, 20);
  EXPECT_GE(child_count(), 3u);
  EXPECT_LE(child_count(), 4u);
}

TEST_F(PeerLoads, WhatFailedToLoadIsTriedAgainLater) {
  const fs::path file = fs::path(testing::TempDir()) / ("loads" + std::to_string(getpid()));
  const std::unique_ptr<LoadedPair> pair = load("dies loading without " + file.string());
  EXPECT_THROW(says(*pair), EngineFailure);
  std::ofstream(file) << "now";
  const auto start = std::chrono::steady_clock::now();
  bool is_loaded = false;
  while (!is_loaded && std::chrono::steady_clock::now() - start < std::chrono::seconds(30)) {
    try {
      says(*pair);
      is_loaded = true;
    } catch (const EngineFailure&) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  EXPECT_TRUE(is_loaded);
  fs::remove(file);
}

}  // namespace
}  // namespace graze::compare
