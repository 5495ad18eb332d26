// Help, version and everything that is wrong before a mesh is read.

#include <array>

#include "tests/engine/cli/command_test.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::tests {
namespace {

class CliUsage : public CommandTest {
 protected:
  CliUsage() {
    write_mesh("a.off", make_box({1, 1, 1}));
    write_mesh("b.off", make_box({0.5, 0.5, 0.5}));
  }
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(CliUsage, HelpOfEachCommandSuffices) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"--help"},
                                                    {"info", "--help"},
                                                    {"pair", "--help"},
                                                    {"pair", "-h"},
                                                    {"voxels", "--help"}}) {
    const CommandResult result = graze(arguments);
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "");
    for (const char* part : {"Examples:", "Exit codes:", "metres", "graze "}) {
      EXPECT_TRUE(contains(result.out, part)) << arguments[0] << ": " << part;
    }
  }
}

TEST_F(CliUsage, HelpNamesEveryOption) {
  const std::string program = graze({"--help"}).out;
  for (const char* part : {"info", "pair", "voxels", "--version"})
    EXPECT_TRUE(contains(program, part)) << part;
  const std::string info = graze({"info", "--help"}).out;
  for (const char* part : {"MESH", "--json", "--self", "--progress"}) {
    EXPECT_TRUE(contains(info, part)) << part;
  }
  const std::string pair = graze({"pair", "--help"}).out;
  for (const char* part : {"--pose-a", "--pose-b", "--poses", "--query", "any|pairs", "--list",
                           "--check", "--json", "--progress", "--threads", "FILE:LINE"}) {
    EXPECT_TRUE(contains(pair, part)) << part;
  }
  const std::string voxels = graze({"voxels", "--help"}).out;
  for (const char* part :
       {"MESH", "--resolution", "--output", "--solid", "--json", "--progress", "--threads"}) {
    EXPECT_TRUE(contains(voxels, part)) << part;
  }
}

TEST_F(CliUsage, LinesOfHelpFitATerminal) {
  for (const char* command : {"info", "pair", "voxels"}) {
    for (const std::string& line : lines_of(graze({command, "--help"}).out)) {
      EXPECT_LE(line.size(), 100u) << line;
    }
  }
}

TEST_F(CliUsage, VersionIsOneLine) {
  const CommandResult result = graze({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, "graze " GRAZE_VERSION "\n");
}

TEST_F(CliUsage, WrongArgumentsAreRefusedInOneLine) {
  // CLI11 words these, differently from version to version: what matters is what they name.
  const auto refuse = [&](const std::vector<std::string>& arguments, const std::string& culprit) {
    const CommandResult result = graze(arguments);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(lines_of(result.err).size(), 1u) << result.err;
    EXPECT_TRUE(result.err.starts_with("graze: ")) << result.err;
    EXPECT_TRUE(contains(result.err, culprit)) << result.err;
    const bool is_of_subcommand = !arguments.empty();
    EXPECT_TRUE(result.err.ends_with(is_of_subcommand ? " " + arguments[0] + " --help)\n"
                                                      : "(see graze --help)\n"))
        << result.err;
  };
  refuse({}, "subcommand");
  refuse({"info"}, "MESH");
  refuse({"voxels", "a.off", "-o", "v.obj"}, "--resolution");
  refuse({"voxels", "a.off", "--resolution", "8"}, "--output");
  refuse({"voxels", "-o", "v.obj", "--resolution", "8"}, "MESH");
  refuse({"pair"}, "A ");
  refuse({"pair", "a.off"}, "B ");
  refuse({"pair", "a.off", "b.off", "--fast"}, "--fast");
  refuse({"pair", "a.off", "b.off", "--query", "most"}, "--query");
  refuse({"pair", "a.off", "b.off", "--check", "bullet"}, "--check");
  expect_refusal({"collide", "a.off", "b.off"},
                 "graze: there is no subcommand \"collide\" (see graze --help)");
}

TEST_F(CliUsage, OptionsThatExcludeEachOtherAreRefused) {
  write("poses.txt", kIdentity);
  expect_refusal({"pair", "a.off", "b.off", "--list", "--query", "any"},
                 "graze: --list needs --query pairs: --query any stops at the first pair it finds");
  expect_refusal({"pair", "a.off", "b.off", "--pose-b", kIdentity, "--poses", "poses.txt"},
                 "graze: --pose-b and --poses exclude each other: both place B");
}

TEST_F(CliUsage, BadPosesOnTheCommandLineAreRefused) {
  const auto refuse = [&](const std::string& pose, const std::string& why) {
    expect_refusal({"pair", "a.off", "b.off", "--pose-b", pose}, "graze: --pose-b: " + why);
  };
  refuse("1 0 0 0 0 1 0 0 0 0 1", "11 numbers, a pose has 12");
  refuse("1 0 0 0 0 1 0 0 0 0 1 0 0", "13 numbers, a pose has 12");
  refuse("1", "1 number, a pose has 12");
  refuse("1 0 0 0 0 one 0 0 0 0 1 0", "number 6: \"one\" is not a number");
  refuse("1 0 0 0 0 1x 0 0 0 0 1 0", "number 6: \"1x\" is not a number");
  refuse("1 0 0 nan 0 1 0 0 0 0 1 0", "number 4: \"nan\" is not finite");
  refuse("1 0 0 -inf 0 1 0 0 0 0 1 0", "number 4: \"-inf\" is not finite");
  refuse("1 0 0 1e999 0 1 0 0 0 0 1 0", "number 4: \"1e999\" is not finite");
  refuse("1 0 0 +-1 0 1 0 0 0 0 1 0", "number 4: \"+-1\" is not a number");
  refuse("1 0 0 0x1 0 1 0 0 0 0 1 0", "number 4: \"0x1\" is not a number");
  refuse("1 0 0,,0 0 1 0 0 0 0 1 0", "a comma without a number before it");
  refuse("1 0 0 0 0 1 0 0 0 0 1 0,", "a comma without a number after it");
  refuse("2 0 0 0 0 2 0 0 0 0 2 0", "not a rotation, max |R^T R - I| is 3, above 1e-06");
  refuse("1 0 0 0 0 1 0 0 0 0 -1 0", "the determinant is negative, this is a reflection");
  expect_refusal({"pair", "a.off", "b.off", "--pose-a", "1 2"},
                 "graze: --pose-a: 2 numbers, a pose has 12");
  expect_refusal({"pair", "a.off", "b.off", "--pose-b", "1", "0", "--json"},
                 "graze: --pose-b: 2 numbers, a pose has 12");
}

TEST_F(CliUsage, APoseOptionWithoutAPoseIsRefused) {
  for (const std::vector<std::string>& rest :
       {std::vector<std::string>{"--pose-b"}, {"--pose-b", "--json"}}) {
    std::vector<std::string> arguments = {"pair", "a.off", "b.off"};
    arguments.insert(arguments.end(), rest.begin(), rest.end());
    const CommandResult result = graze(arguments);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(lines_of(result.err).size(), 1u);
    EXPECT_TRUE(contains(result.err, "graze: --pose-b")) << result.err;
  }
}

TEST_F(CliUsage, BadPoseFilesAreRefusedWithTheirLine) {
  const auto refuse = [&](const std::string& text, const std::string& message) {
    write("poses.txt", text);
    expect_refusal({"pair", "a.off", "b.off", "--poses", "poses.txt"},
                   "graze: poses.txt" + message);
  };
  const std::string good = std::string(kIdentity) + "\n";
  refuse(good + "\n1 0 0 0 0 1.1 0 0 0 0 1 0\n",
         ":3: not a rotation, max |R^T R - I| is 0.21, above 1e-06");
  refuse(good + good + "1 0 0 0 0 1 0 0 0 0 1\n", ":3: 11 numbers, a pose has 12");
  refuse(good + "1 0 0 0 0 1 0 0 0 0 1 z", ":2: number 12: \"z\" is not a number");
  refuse(good + "# a comment\n", ":2: number 1: \"#\" is not a number");
  refuse("1 0 0 nan 0 1 0 0 0 0 1 0\n", ":1: number 4: \"nan\" is not finite");
  refuse(good + std::string(70000, ' ') + "\n", ":2: longer than 65535 bytes");
  refuse(good + std::string("1 0 0 0 0 1 0 0 0 0 1 0\0", 24) + "\n",
         ":2: number 12: \"0\\x00\" is not a number");
  refuse("", ": no poses");
  refuse("\n  \n\t\r\n", ": no poses");
  expect_refusal({"pair", "a.off", "b.off", "--poses", "missing.txt"},
                 "graze: missing.txt: No such file or directory");
  expect_refusal({"pair", "a.off", "b.off", "--poses", "."}, "graze: .: is a directory");
  // A script's unset variable must not be answered for the identity pose.
  expect_refusal({"pair", "a.off", "b.off", "--poses", ""},
                 "graze: --poses: the name of the file is empty");
}

TEST_F(CliUsage, PosesThatOverflowAreRefusedBeforeTheFirstQuery) {
  const std::string far = "1 0 0 1e308 0 1 0 0 0 0 1 0";
  write_mesh("huge.off", make_box({1e308, 1, 1}));
  write("poses.txt", std::string(kIdentity) + "\n" + far + "\n");
  for (const auto& [option, value, place] :
       {std::array<std::string, 3>{"--pose-a", far, "--pose-a"},
        {"--pose-b", far, "--pose-b"},
        {"--poses", "poses.txt", "poses.txt:2"}}) {
    const CommandResult result = graze({"pair", "huge.off", "huge.off", option, value});
    EXPECT_EQ(result.exit_code, 2) << option;
    EXPECT_EQ(result.out, "") << option;
    EXPECT_EQ(result.err.find("graze: " + place + ": "), 0u) << result.err;
    EXPECT_EQ(lines_of(result.err).size(), 1u) << result.err;
  }
}

TEST_F(CliUsage, ManyPosesBeforeABadOneLeaveStdoutEmpty) {
  std::string poses;
  for (int i = 0; i < 1000; ++i)
    poses += std::string(kIdentity) + "\n";
  write("poses.txt", poses + "1 2 3\n");
  expect_refusal({"pair", "a.off", "b.off", "--poses", "poses.txt", "--json"},
                 "graze: poses.txt:1001: 3 numbers, a pose has 12");
}

}  // namespace
}  // namespace graze::tests
