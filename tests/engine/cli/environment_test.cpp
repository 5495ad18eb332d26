// The command where its caller left it little: closed streams, no environment, a folder that is
// gone, names of files that are no text. It answers as ever, or says in one line why not.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/engine/cli/command_test.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"

namespace graze::tests {
namespace {

class CliEnvironment : public CommandTest {
 protected:
  CliEnvironment() {
    write_mesh("a.off", make_box({1, 1, 1}));
    write_mesh("b.off", make_box({0.5, 0.5, 0.5}));
  }

  CommandResult shell(const std::string& line) const { return run_shell(folder_, line); }

  std::string read(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(CliEnvironment, ClosedStreamsFailAsSuchAndNothingElseDoes) {
  EXPECT_EQ(shell("$GRAZE info a.off <&-").exit_code, 0);
  EXPECT_EQ(shell("$GRAZE info a.off 2>&-").out, shell("$GRAZE info a.off").out);
  EXPECT_EQ(shell("$GRAZE info none.off 2>&-").exit_code, 2);
  const CommandResult result = shell("$GRAZE info a.off >&-");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err, "graze: cannot write to standard output: Bad file descriptor\n");
  EXPECT_EQ(shell("$GRAZE info a.off <&- >&- 2>&-").exit_code, 2);
  EXPECT_EQ(shell("$GRAZE info none.off <&- >&- 2>&-").exit_code, 2);
}

/// No file that the command writes takes the place of a stream that its caller has closed: FCL, for
/// one, says on standard error that an iteration of its own did not end.
TEST_F(CliEnvironment, WhatIsSaidToAClosedStreamGoesIntoNoFile) {
  std::filesystem::create_directory(folder_ / "cases");
  for (const char* name : {"triangles-04.json", "triangles-25.json", "by-hand-segment.json"})
    std::filesystem::copy(std::filesystem::path(GRAZE_DATA_DIR "/regressions") / name,
                          folder_ / "cases");
  const std::string compare = "$GRAZE compare cases --threads 1 --resume record --json";
  for (const char* closed : {"2>&-", "<&- 2>&-", "<&- >&- 2>&-"}) {
    std::filesystem::remove(folder_ / "record");
    shell(compare + " > out.txt " + closed);
    const std::vector<std::string> lines = lines_of(read("record"));
    EXPECT_EQ(lines.size(), 4u) << closed;  // what is compared, and each case
    for (const std::string& line : lines)
      EXPECT_TRUE(line.starts_with("{") && line.ends_with("}")) << closed << ": " << line;
  }
  EXPECT_EQ(shell(compare + " > out.txt").exit_code, 0);  // the record is read again
}

TEST_F(CliEnvironment, NothingInTheEnvironmentIsNeeded) {
  const std::string expected = shell("$GRAZE info a.off").out;
  for (const char* environment :
       {"-i", "-u HOME -u PATH", "LC_ALL=de_DE.UTF-8 LANG=de_DE.UTF-8 LC_NUMERIC=de_DE",
        "LC_ALL=none", "TZ=nowhere", "TMPDIR=/nowhere", "NO_COLOR=1 COLUMNS=1 TERM="}) {
    const CommandResult result = shell("env " + std::string(environment) + " $GRAZE info a.off");
    EXPECT_EQ(result.exit_code, 0) << environment;
    EXPECT_EQ(result.out, expected) << environment;
    EXPECT_EQ(result.err, "") << environment;
  }
}

#if defined(GRAZE_OTHER_ARITHMETIC) && defined(__x86_64__)
/// Flushed to zero, rounded up, down and towards zero, all exceptions trapped, and all at once: the
/// command, whose judge computes for itself, and the processes of other engines.
TEST_F(CliEnvironment, LibrariesThatComputeOtherwiseChangeNothing) {
  std::filesystem::create_directory(folder_ / "cases");
  for (const char* name : {"triangles-04.json", "by-hand-drum-and-ball.json", "ode-rock-0.json"})
    std::filesystem::copy(std::filesystem::path(GRAZE_DATA_DIR "/regressions") / name,
                          folder_ / "cases");
  write_mesh("odd.off", make_box({0.1, 1e-310, 3.3}));
  for (const char* command : {"info odd.off", "pair a.off odd.off", "replay cases --json"}) {
    const std::string timeless =
        std::string(command) + R"( | sed -E 's/"us":[^,}]*//g;s/ *[0-9.]+( ms)?$//')";
    const CommandResult expected = shell("$GRAZE " + timeless);
    EXPECT_NE(expected.out, "");
    for (const char* word : {"0x9fc0", "0x3f80", "0x5f80", "0x7f80", "0x1900", "0xf940"}) {
      const CommandResult result =
          shell("env GRAZE_CONTROL_WORD=" + std::string(word) +
                " LD_PRELOAD=" GRAZE_OTHER_ARITHMETIC " $GRAZE " + timeless);
      EXPECT_EQ(result.out, expected.out) << command << ' ' << word;
      EXPECT_EQ(result.err, expected.err) << command << ' ' << word;
    }
  }
}
#endif

TEST_F(CliEnvironment, TheFolderMayBeGone) {
  const std::string gone = "d=$PWD; mkdir gone; cd gone; rmdir ../gone; $GRAZE ";
  EXPECT_EQ(shell(gone + "info \"$d/a.off\"").exit_code, 0);
  EXPECT_EQ(shell(gone + "pair \"$d/a.off\" \"$d/b.off\"").exit_code, 0);
  for (const char* arguments : {"info a.off", "voxels \"$d/a.off\" --resolution 4 -o v.ply",
                                "compare \"$d/a.off\" \"$d/b.off\" --save base --cases cases"}) {
    const CommandResult result = shell(gone + arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_TRUE(contains(result.err, "graze: ")) << result.err;
  }
}

/// What a folder of tests may hold: blanks, quotes, line breaks, bytes that are no UTF-8.
TEST_F(CliEnvironment, NamesOfFilesMayBeAnything) {
  for (const std::string name : {"a b.off", "it's \"so\".off", "two\nlines.off", "bad\xff.off",
                                 "-x\\y.off", "$(exit 1).off", "na\xc3\xafve.off"}) {
    std::filesystem::copy(folder_ / "a.off", folder_ / name);
    const CommandResult info = graze({"info", "--json", "./" + name});
    EXPECT_EQ(info.exit_code, 0) << name;
    EXPECT_EQ(lines_of(info.out).size(), 1u) << name;
    EXPECT_EQ(
        graze({"voxels", "./" + name, "--resolution", "4", "-o", "v" + name + ".ply"}).exit_code,
        0);
    EXPECT_TRUE(std::filesystem::exists(folder_ / ("v" + name + ".ply"))) << name;
    const CommandResult none = graze({"info", "./none " + name});
    EXPECT_EQ(none.exit_code, 2) << name;
    EXPECT_EQ(lines_of(none.err).size(), 1u) << none.err;
  }
}

/// The commands that a report says can be given to a shell, whatever the files are called.
TEST_F(CliEnvironment, CommandsThatAreSaidCanBeRun) {
  for (const std::string name :
       {"a b", "it's \"so\"", "two\nlines", "bad\xff", "-x\\y", "$(exit 1)"}) {
    const std::string folder = "./of " + name;
    const CommandResult compared =
        graze({"compare", GRAZE_DATA_DIR "/meshes/gear.ply", GRAZE_DATA_DIR "/meshes/pinion.off",
               "--grazing", "5", "--cases", folder});
    EXPECT_EQ(compared.exit_code, 0);
    const bool is_fcl_here = contains(compared.out, "fcl ") && !contains(compared.out, "fcl: not");
    bool is_one_run = false;
    for (const std::string& line : lines_of(compared.out)) {
      if (!line.starts_with("shrunk: graze replay ")) continue;
      const std::string arguments = line.substr(line.find("replay"));
      write("line", "\"$GRAZE\" " + arguments.substr(0, arguments.find(".json") + 6) + "\n");
      const CommandResult replayed = shell("bash line");
      EXPECT_EQ(replayed.exit_code, 0) << line;
      EXPECT_TRUE(contains(replayed.out, "graze " GRAZE_VERSION)) << line;
      is_one_run = true;
      break;
    }
    EXPECT_EQ(is_one_run, is_fcl_here) << compared.out;
  }
}

}  // namespace
}  // namespace graze::tests
