// The files that the command writes: whole or as they were, whatever fails and whatever they are
// called.

#include <gtest/gtest.h>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "tests/engine/cli/command_test.h"
#include "tests/files/devices.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::tests {
namespace {

namespace fs = std::filesystem;

class CliFiles : public CommandTest {
 protected:
  CliFiles() {
    write_mesh("a.off", make_torus(1, 0.25, 10, 8));
    write_mesh("b.off", make_box({0.5, 0.5, 0.5}));
  }

  std::string read(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  /// All but what the test itself has put there.
  std::set<std::string> names() const {
    std::set<std::string> all;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
      all.insert(entry.path().filename().string());
    for (const char* own : {"a.off", "b.off", ".stdout", ".stderr"})
      all.erase(own);
    return all;
  }

  /// compare, of two poses, with these arguments.
  CommandResult compare(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"compare", "a.off", "b.off", "--engines", "graze",
                                         "--random", "2", "--threads", "1"});
    return graze(arguments);
  }

  void expect_refused(const std::vector<std::string>& arguments, const std::string& line) const {
    const CommandResult result = compare(arguments);
    EXPECT_EQ(result.exit_code, 2) << line;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "graze: " + line + "\n");
  }
};

using Names = std::set<std::string>;

TEST_F(CliFiles, AFailedWriteLeavesTheOldFile) {
  write("old.ply", "old");
  fs::create_symlink("old.ply", folder_ / "link.ply");
  const CommandResult result =
      run_shell(folder_, "ulimit -f 8; \"$GRAZE\" voxels a.off --resolution 60 -o link.ply");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, "graze: link.ply: cannot be written: File too large\n");
  EXPECT_EQ(read("old.ply"), "old");
  EXPECT_EQ(names(), (Names{"old.ply", "link.ply"}));
  EXPECT_EQ(graze({"voxels", "a.off", "--resolution", "60", "-o", "link.ply"}).exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.ply"));
  EXPECT_GT(fs::file_size(folder_ / "old.ply"), 10000u);
}

/// The old file or the whole new one, and never anything else. Once at least it is the old one.
TEST_F(CliFiles, ASignalLeavesTheOldFileAndNothingElse) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    bool is_hit = false;
    for (int i = 0; i < 20 && !is_hit; ++i) {
      write("old.obj", "old");
      const CommandResult result = interrupt_graze(
          folder_, {"voxels", "a.off", "--resolution", "160", "-o", "old.obj"},
          [&] { return names().size() > 1; }, signal);
      EXPECT_EQ(names(), Names{"old.obj"}) << signal;
      is_hit = result.exit_code == -1;
      if (is_hit) {
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(read("old.obj"), "old") << signal;
      } else {
        EXPECT_GT(fs::file_size(folder_ / "old.obj"), 1000000u);
      }
    }
    EXPECT_TRUE(is_hit) << "the signal always came too late";
  }
}

TEST_F(CliFiles, DevicesAreNeverReplaced) {
  const TemporaryDirectory devices;
  const std::string full = spare_device(Device::Full, devices.path());
  const std::string null = spare_device(Device::Null, devices.path());
  if (full.empty() || null.empty()) GTEST_SKIP() << "no device to try it on";
  fs::create_symlink(full, folder_ / "full");
  for (const std::string option : {"--save", "--report", "--resume"}) {
    for (const std::string& file : {full, std::string("full")}) {
      expect_refused({option, file}, file + ": cannot be written: No space left on device");
      EXPECT_TRUE(fs::is_character_file(full));
    }
    EXPECT_EQ(compare({option, null}).exit_code, 0) << option;
    EXPECT_TRUE(fs::is_character_file(null));
  }
  EXPECT_EQ(names(), Names{"full"});
}

TEST_F(CliFiles, PipesAndStandardOutputAreWrittenThrough) {
  ASSERT_EQ(compare({"--save", "file"}).exit_code, 0);
  const std::size_t lines = lines_of(read("file")).size();
  const std::string run = "\"$GRAZE\" compare a.off b.off --engines graze --random 2 --threads 1 ";
  for (const std::string option : {"--save", "--resume"}) {
    const CommandResult piped =
        run_shell(folder_, "mkfifo p; cat p > copy & " + run + option + " p > /dev/null && wait");
    EXPECT_EQ(piped.exit_code, 0) << piped.err;
    EXPECT_EQ(lines_of(read("copy")).size(), lines) << option;
    EXPECT_TRUE(fs::is_fifo(folder_ / "p"));
    fs::remove(folder_ / "p");
    const CommandResult through =
        run_shell(folder_, "echo before > all; { " + run + option + " /dev/stdout; } >> all");
    EXPECT_EQ(through.exit_code, 0) << through.err;
    const std::vector<std::string> all = lines_of(read("all"));
    ASSERT_GT(all.size(), lines + 1) << "the record, and then what is printed";
    EXPECT_EQ(all.front(), "before");
    EXPECT_TRUE(nlohmann::json::accept(all[1]) && nlohmann::json::accept(all[lines])) << all[1];
  }
}

TEST_F(CliFiles, NamesThatCannotBeMeantAreRefusedBeforeTheWork) {
  fs::create_directory(folder_ / "folder");
  write("file", "old");
  const std::string longest(256, 'n');
  for (const std::string option : {"--save", "--report", "--resume"}) {
    expect_refused({option, longest}, longest + ": cannot be written: File name too long");
    expect_refused({option, "folder"}, option + ": folder: is a folder");
    expect_refused({option, "folder/"}, option + ": folder/: is a folder");
    expect_refused({option, "file/new"}, option + ": file/new: there is no folder file");
    expect_refused({option, ""}, option + ": \"\" is no name of a file (see graze compare --help)");
    expect_refused({option, "./a.off"}, option + ": ./a.off is A itself");
    fs::create_hard_link(folder_ / "b.off", folder_ / "other-name");
    expect_refused({option, "other-name"}, option + ": other-name is B itself");
    fs::remove(folder_ / "other-name");
  }
  expect_refused({"--save", "new", "--report", "folder/../new"},
                 "--report: folder/../new is the file of --save, too");
  expect_refused({"--save", "new", "--resume", "./new"},
                 "--save: new is the file of --resume, too");
  const TemporaryDirectory devices;
  const std::string null = spare_device(Device::Null, devices.path());
  if (!null.empty()) {
    EXPECT_EQ(compare({"--save", null, "--report", null}).exit_code, 0);
  }
  EXPECT_EQ(names(), (Names{"folder", "file"}));
  EXPECT_EQ(read("file"), "old");
  const CommandResult same =
      run_shell(folder_, "\"$GRAZE\" voxels a.off --resolution 8 -o v.ply > v.ply");
  EXPECT_EQ(same.exit_code, 2);
  EXPECT_EQ(same.err, "graze: -o: v.ply is where standard output goes\n");
}

TEST_F(CliFiles, AGateMaySaveWhatTheNextRunIsHeldAgainst) {
  EXPECT_EQ(compare({"--save", "base"}).exit_code, 0);
  const CommandResult again =
      compare({"--save", "base", "--against", "base", "--time-tolerance", "1e9"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  expect_refused({"--report", "base", "--against", "base"},
                 "--report: base is the file of --against");
}

TEST_F(CliFiles, AnOutputAmongTheCasesIsRefused) {
  fs::create_directory(folder_ / "cases");
  const std::string line = "graze: --save: cases/base.json lies among the cases of cases\n";
  const CommandResult result = graze({"compare", "cases", "--save", "cases/base.json"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err, line);
}

}  // namespace
}  // namespace graze::tests
