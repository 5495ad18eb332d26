// `graze compare` as a program that is killed, in parts, and with many poses.

#include <gtest/gtest.h>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/engine/cli/command_test.h"
#include "tests/engine/cli/saved_poses.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::tests {
namespace {

using nlohmann::json;

class CompareKilled : public CommandTest {
 protected:
  CompareKilled() {
    write_mesh("a.off", make_torus(1, 0.25, 24, 16));
    write_mesh("b.off", make_sphere(0.5, 12, 18));
  }

  std::vector<std::string> command(const std::string& poses,
                                   const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all = {"compare", "a.off",     "b.off", "--random", poses,
                                    "--json",  "--engines", "graze", "--keep",   "0"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  /// The summary, without what hangs on times.
  static std::string totals(const std::string& out) {
    const std::size_t at = out.rfind("{\"summary\"");
    if (at == out.npos) return "no summary";
    json summary = json::parse(out.substr(at, out.find('\n', at) - at));
    for (json& engine : summary["summary"]) {
      engine.erase("median_us");
      engine.erase("total_us");
    }
    return summary.dump();
  }

  std::uintmax_t recorded_bytes(const char* name) const {
    std::error_code none_yet;
    const std::uintmax_t size = std::filesystem::file_size(folder_ / name, none_yet);
    return none_yet ? 0 : size;
  }

  /// Poses in a row, as numpy saves them.
  void write_poses(const std::string& name, std::size_t count) const {
    save_poses(folder_ / name, count, [](std::size_t i) {
      Pose pose = Pose::Identity();
      pose.translation() << 0.5 + static_cast<double>(i % 1000) / 1000, 0.125, 0.0625;
      return pose;
    });
  }
};

TEST_F(CompareKilled, GoesOnToTheSameTotals) {
  const std::string poses = "60000";
  const CommandResult whole = run_graze(folder_, command(poses, {"--save", "whole"}));
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  const std::vector<std::string> resumed = command(poses, {"--resume", "run"});
  for (const std::uintmax_t bytes : {1, 100'000}) {
    interrupt_graze(
        folder_, resumed, [&] { return recorded_bytes("run") >= bytes; }, SIGKILL);
  }
  const CommandResult result = run_graze(folder_, resumed);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(totals(result.out), totals(whole.out));
  std::vector<std::string> lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 60001u) << "one for each pose";
  for (std::size_t i = 0; i < 60000; i += 997)
    EXPECT_EQ(json::parse(lines[i])["pose"], i);
  // The record knows all of it: a run with it asks nothing, and writes the same.
  const CommandResult again = run_graze(folder_, resumed);
  EXPECT_EQ(again.out, result.out) << "times, too";
}

TEST_F(CompareKilled, ManyPosesTakeNoMoreMemory) {
  write_poses("few.npy", 5000);
  write_poses("many.npy", 100'000);
  const auto with = [&](const char* poses) {
    return std::vector<std::string>{"compare",   "a.off",     "b.off",  "--poses", poses,
                                    "--engines", "graze",     "--keep", "0",       "--save",
                                    "run",       "--threads", "2"};
  };
  const long few = peak_memory_of_graze(folder_, with("few.npy"));
  const long many = peak_memory_of_graze(folder_, with("many.npy"));
  ASSERT_GT(few, 1000);
  ASSERT_GT(many, 0);
  // Held, the 95,000 poses more would take 12 MB, and their answers a hundred.
  EXPECT_LT(many, few + 8'000) << "kB";
}

TEST_F(CompareKilled, ManyPosesOfATextTakeNoMoreMemory) {
  const auto write = [&](const char* name, std::size_t count) {
    std::ofstream file(folder_ / name);
    for (std::size_t i = 0; i < count; ++i)
      file << "1 0 0 " << 0.5 + static_cast<double>(i % 1000) / 1000
           << " 0 1 0 0.125 0 0 1 0.0625\n";
  };
  write("few.txt", 5000);
  write("many.txt", 100'000);
  const auto with = [&](const char* poses) {
    return std::vector<std::string>{"compare", "a.off",  "b.off", "--poses",   poses, "--engines",
                                    "graze",   "--keep", "0",     "--threads", "2"};
  };
  const long few = peak_memory_of_graze(folder_, with("few.txt"));
  const long many = peak_memory_of_graze(folder_, with("many.txt"));
  ASSERT_GT(few, 1000);
  ASSERT_GT(many, 0);
  EXPECT_LT(many, few + 8'000) << "kB";
}

TEST_F(CompareKilled, HostileFilesAreOneLineAndExitCodeTwo) {
  std::ofstream(folder_ / "junk") << std::string(100, '\xff') << "\n{\"graze_comparison\":2}\n";
  std::ofstream(folder_ / "empty");
  for (const char* file : {"junk", "empty", "nowhere", "."}) {
    for (const std::vector<std::string>& arguments :
         {command("5", {"--against", file}), command("5", {"--answers", file}),
          std::vector<std::string>{"merge", file}}) {
      const CommandResult result = run_graze(folder_, arguments);
      EXPECT_EQ(result.exit_code, 2) << arguments.back();
      EXPECT_EQ(result.out, "");
      EXPECT_EQ(lines_of(result.err).size(), 1u) << result.err;
    }
  }
}

}  // namespace
}  // namespace graze::tests
