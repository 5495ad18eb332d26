// `graze compare --resume` as a program that is interrupted from outside.

#include <gtest/gtest.h>
#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/engine/cli/command_test.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::tests {
namespace {

class CompareInterrupted : public CommandTest {
 protected:
  CompareInterrupted() {
    write_mesh("a.off", make_torus(1, 0.25, 24, 16));
    write_mesh("b.off", make_sphere(0.5, 12, 18));
  }

  std::string record() const {
    std::ifstream file(folder_ / "run.jsonl", std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::size_t lines() const {
    const std::string text = record();
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }

  /// Interrupts it once it has recorded so many poses of far more than it could answer meanwhile:
  /// every distance goes to the referee.
  CommandResult interrupted_after(std::size_t poses) const {
    return interrupt_graze(folder_,
                           {"compare", "a.off", "b.off", "--query", "distance", "--random", "50000",
                            "--resume", "run.jsonl", "--engines", "graze"},
                           [&] { return lines() > poses; });
  }
};

TEST_F(CompareInterrupted, LeavesAWholeRecordAndSaysHowToGoOn) {
  std::size_t before = 0;
  for (const std::size_t poses : {3, 9}) {
    const CommandResult result = interrupted_after(poses);
    EXPECT_EQ(result.exit_code, 130) << result.err;
    EXPECT_EQ(result.out, "");
    const std::vector<std::string> said = lines_of(result.err);
    ASSERT_EQ(said.size(), 1u) << result.err;
    const std::size_t done = lines() - 1;
    EXPECT_EQ(said.front(), "graze: interrupted: " + std::to_string(done) +
                                " of 50000 poses done, go on with --resume run.jsonl");
    EXPECT_GE(done, poses);
    EXPECT_GT(done, before);
    before = done;
    const std::string text = record();
    EXPECT_EQ(text.back(), '\n');
    for (const std::string& line : lines_of(text))
      EXPECT_TRUE(nlohmann::json::accept(line)) << line;
  }
}

}  // namespace
}  // namespace graze::tests
