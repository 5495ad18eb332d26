// `graze compare --resume` as a program that is interrupted from outside.

#include <gtest/gtest.h>
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
  /// How many poses the lines of the record have together.
  std::size_t poses() const {
    std::size_t count = 0;
    std::string text = record();
    text.resize(text.rfind('\n') + 1);  // without the line that is being written
    for (const std::string& line : lines_of(text)) {
      const nlohmann::json block = nlohmann::json::parse(line);
      if (block.contains("agreed")) count += block["poses"][1].get<std::size_t>();
    }
    return count;
  }

  /// Interrupts it once it has recorded so many poses of far more than it could answer meanwhile:
  /// every distance goes to the referee.
  CommandResult interrupted_after(std::size_t poses) const {
    return interrupt_graze(folder_,
                           {"compare", "a.off", "b.off", "--query", "distance", "--random", "50000",
                            "--resume", "run.jsonl", "--engines", "graze"},
                           [&] { return this->poses() > poses; });
  }
};

TEST_F(CompareInterrupted, LeavesAWholeRecordAndSaysHowToGoOn) {
  std::size_t before = 0;
  for (const std::size_t least : {3, 9}) {
    const CommandResult result = interrupted_after(before + least);
    EXPECT_EQ(result.exit_code, 130) << result.err;
    EXPECT_EQ(result.out, "");
    const std::vector<std::string> said = lines_of(result.err);
    ASSERT_EQ(said.size(), 1u) << result.err;
    const std::size_t done = poses();
    EXPECT_EQ(said.front(), "graze: interrupted: " + std::to_string(done) +
                                " of 50000 poses done, go on with --resume run.jsonl");
    EXPECT_GE(done, least);
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
