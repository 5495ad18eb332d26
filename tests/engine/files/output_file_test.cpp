// The one way to write a file: what appears, what stays, and what is never replaced.

#include <fcntl.h>
#include <graze/engine/files/file_error.h>
#include <graze/engine/files/output_file.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>
#include <string>
#include <thread>

#include "tests/files/devices.h"
#include "tests/files/temporary_directory.h"

namespace graze::files {
namespace {

namespace fs = std::filesystem;

class OutputFiles : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return directory_.path(name); }

  std::string read(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  std::set<std::string> names() const {
    std::set<std::string> all;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory_.path()))
      all.insert(entry.path().filename().string());
    return all;
  }

  static std::string error_of(const std::function<void()>& body) {
    try {
      body();
    } catch (const FileError& error) {
      return error.what();
    }
    return "";
  }

  tests::TemporaryDirectory directory_;
};

using Names = std::set<std::string>;

TEST_F(OutputFiles, HoldWhatWasAppendedAcrossTheBuffer) {
  std::string expected;
  {
    OutputFile file(path("a"));
    for (std::size_t length : {0u, 1u, 65535u, 65536u, 65537u, 200000u}) {
      const std::string part(length, static_cast<char>('a' + length % 26));
      file.append(part);
      expected += part;
    }
    file.finish();
  }
  EXPECT_EQ(read("a"), expected);
  EXPECT_EQ(names(), Names{"a"});
}

TEST_F(OutputFiles, AreWholeOrAsTheyWere) {
  directory_.write("old", "old");
  for (const std::string name : {"old", "new"}) {
    {
      OutputFile file(path(name));
      file.append(std::string(100000, 'x'));
      file.flush();
      EXPECT_EQ(fs::exists(path(name)), name == "old") << "nothing half written is to be seen";
      EXPECT_EQ(read("old"), "old");
      EXPECT_EQ(names().size(), 2u) << "the other one lies beside it";
    }
    EXPECT_EQ(names(), Names{"old"}) << name;
  }
  {
    OutputFile file(path("old"));
    file.append("more than before");
    file.finish();
  }
  EXPECT_EQ(read("old"), "more than before");
}

TEST_F(OutputFiles, CanGrowOnceTheyAreThere) {
  directory_.write("a", "old");
  OutputFile file(path("a"));
  file.append("1\n");
  file.publish();
  EXPECT_EQ(read("a"), "1\n");
  file.append("2\n");
  EXPECT_EQ(read("a"), "1\n");
  file.flush();
  EXPECT_EQ(read("a"), "1\n2\n");
  EXPECT_EQ(names(), Names{"a"});
}

/// Files of this process cannot grow beyond so many bytes while this lives.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    handler_ = signal(SIGXFSZ, SIG_IGN);  // writing then fails with EFBIG
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

TEST_F(OutputFiles, AFailedWriteIsTypedAndChangesNothing) {
  directory_.write("real", "old");
  fs::create_symlink("real", path("link"));
  std::string message;
  {
    const FileSizeLimit limit(100000);
    message = error_of([&] { write_file(path("link"), std::string(300000, 'x')); });
  }
  EXPECT_EQ(message, path("link") + ": cannot be written: File too large");
  EXPECT_EQ(read("real"), "old");
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(names(), (Names{"real", "link"}));
}

TEST_F(OutputFiles, LinksStayAndLeadToWhatIsWritten) {
  fs::create_directory(path("folder"));
  directory_.write("folder/real", "old");
  fs::create_symlink("folder/second", path("first"));  // each is read from where it lies
  fs::create_symlink("../third", path("folder/second"));
  fs::create_symlink(directory_.path() / "folder/real", path("third"));
  fs::create_symlink("folder", path("folder_link"));
  write_file(path("first"), "one");
  EXPECT_EQ(read("folder/real"), "one");
  write_file(path("folder_link/real"), "two");
  EXPECT_EQ(read("folder/real"), "two");
  fs::remove(path("folder/real"));
  write_file(path("first"), "three");
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(path("folder/real"))));
  EXPECT_EQ(read("folder/real"), "three") << "where there was none";
  for (const char* link : {"first", "folder/second", "third", "folder_link"})
    EXPECT_TRUE(fs::is_symlink(path(link))) << link;
  EXPECT_EQ(names(), (Names{"first", "folder", "folder_link", "third"}));
  fs::create_symlink("ring", path("ring"));
  EXPECT_EQ(error_of([&] { write_file(path("ring"), "x"); }),
            path("ring") + ": cannot be written: Too many levels of symbolic links");
}

TEST_F(OutputFiles, ModesAreThoseOfTheOldFile) {
  const mode_t before = umask(027);
  write_file(path("new"), "x");
  umask(before);
  struct stat status = {};
  stat(path("new").c_str(), &status);
  EXPECT_EQ(status.st_mode & 07777, 0640u);
  for (const mode_t mode : {0600u, 0664u, 0755u}) {
    chmod(path("new").c_str(), mode);
    write_file(path("new"), "y");
    stat(path("new").c_str(), &status);
    EXPECT_EQ(status.st_mode & 07777, mode);
  }
}

/// Whatever the folder allows, what was there under another name is not what is replaced.
TEST_F(OutputFiles, AnotherNameOfTheOldFileKeepsItsContent) {
  directory_.write("a", "old");
  fs::create_hard_link(path("a"), path("b"));
  write_file(path("a"), "new");
  EXPECT_EQ(read("a"), "new");
  EXPECT_EQ(read("b"), "old");
}

TEST_F(OutputFiles, DevicesStayDevices) {
  const tests::TemporaryDirectory devices;
  const std::string full = tests::spare_device(tests::Device::Full, devices.path());
  const std::string null = tests::spare_device(tests::Device::Null, devices.path());
  if (full.empty() || null.empty()) GTEST_SKIP() << "no device to try it on";
  fs::create_symlink(full, path("full"));
  for (const std::string& name : {full, path("full")}) {
    EXPECT_EQ(error_of([&] { write_file(name, "x"); }),
              name + ": cannot be written: No space left on device");
    EXPECT_TRUE(fs::is_character_file(full));
  }
  write_file(null, "x");
  EXPECT_TRUE(fs::is_character_file(null));
  EXPECT_EQ(names(), Names{"full"});
}

TEST_F(OutputFiles, PipesAreWrittenThrough) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  std::string bytes;
  std::thread reader([&] { bytes = read("pipe"); });
  const std::string sent(300000, 'p');
  write_file(path("pipe"), sent);
  reader.join();
  EXPECT_EQ(bytes, sent);
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
  EXPECT_EQ(names(), Names{"pipe"});
}

TEST_F(OutputFiles, APipeThatNobodyReadsAnyMoreIsAnError) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  close(ends[0]);
  void (*const before)(int) = signal(SIGPIPE, SIG_IGN);
  const std::string name = "/proc/self/fd/" + std::to_string(ends[1]);
  EXPECT_EQ(error_of([&] { write_file(name, "x"); }), name + ": cannot be written: Broken pipe");
  signal(SIGPIPE, before);
  close(ends[1]);
}

/// Its name leads to nobody that could be written to; found out before anything is computed.
TEST_F(OutputFiles, ASocketByItsNameIsRefused) {
  const std::string name = path("socket");
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  ASSERT_LT(name.size(), sizeof address.sun_path);
  name.copy(address.sun_path, name.size());
  const int listener = socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  const std::string expected = name + ": cannot be written: No such device or address";
  EXPECT_EQ(error_of([&] { check_output(name); }), expected);
  EXPECT_EQ(error_of([&] { write_file(name, "x"); }), expected);
  close(listener);
  EXPECT_TRUE(fs::is_socket(name));
  EXPECT_EQ(names(), Names{"socket"});
}

/// A shell's `> file` is behind /dev/stdout: what comes next must go on behind what is written.
TEST_F(OutputFiles, WhatIsOpenAlreadyIsGoneOnWith) {
  const int descriptor = open(path("a").c_str(), O_WRONLY | O_CREAT, 0600);
  ASSERT_EQ(::write(descriptor, "before ", 7), 7);
  for (const std::string folder : {"/proc/self/fd/", "/dev/fd/", "/proc/thread-self/fd/"})
    write_file(folder + std::to_string(descriptor), "through ");
  ASSERT_EQ(::write(descriptor, "after", 5), 5);
  close(descriptor);
  EXPECT_EQ(read("a"), "before through through through after");
  const std::string gone = "/proc/self/fd/" + std::to_string(descriptor);
  EXPECT_EQ(error_of([&] { write_file(gone, "x"); }),
            gone + ": cannot be written: No such file or directory");
}

/// Each is refused with its reason, before the work as after it, and leaves nothing.
TEST_F(OutputFiles, HostilePathsAreRefused) {
  directory_.write("file", "old");
  fs::create_directory(path("folder"));
  fs::create_symlink("missing/new", path("dangling"));
  const std::vector<std::pair<std::string, std::string>> refused = {
      {"", "No such file or directory"},
      {path("folder"), "Is a directory"},
      {path("folder") + "/", "Is a directory"},
      {path("folder") + "/.", "Is a directory"},
      {path("folder") + "/..", "Is a directory"},
      {"/", "Is a directory"},
      {path("new") + "/", "Is a directory"},
      {path("file") + "/", "Not a directory"},
      {path("file") + "/new", "Not a directory"},
      {path("missing/new"), "No such file or directory"},
      {path("dangling"), "No such file or directory"},
      {path(std::string(256, 'n')), "File name too long"},
      {path("folder") + std::string(5000, '/') + "new", "File name too long"},
      {"/proc/self/cwd", "Is a directory"},
  };
  for (const auto& each : refused) {
    const std::string& name = each.first;
    const std::string& why = each.second;
    EXPECT_EQ(error_of([&] { write_file(name, "x"); }), name + ": cannot be written: " + why);
    EXPECT_EQ(error_of([&] { check_output(name); }), name + ": cannot be written: " + why);
  }
  EXPECT_NE(error_of([&] { write_file(std::string("/proc/self/exe"), "x"); }), "");
  EXPECT_NE(error_of([&] { write_file(std::string("/proc/version"), "x"); }), "");
  EXPECT_EQ(names(), (Names{"dangling", "file", "folder"}));
  EXPECT_EQ(read("file"), "old");
  write_file(path(std::string(255, 'n')), "the longest name that there is");
  EXPECT_EQ(names().size(), 4u);
}

TEST_F(OutputFiles, ACheckCreatesNothingAndOpensNothing) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  directory_.write("file", "old");
  for (const std::string& name :
       {path("pipe"), path("file"), path("new"), std::string("/proc/self/fd/2")})
    EXPECT_EQ(error_of([&] { check_output(name); }), "") << name;
  EXPECT_EQ(names(), (Names{"pipe", "file"}));
}

TEST_F(OutputFiles, WithoutPermissionNothingIsReplaced) {
  if (geteuid() == 0) GTEST_SKIP() << "permissions do not bind who runs the tests";
  directory_.write("file", "old");
  chmod(path("file").c_str(), 0444);
  const std::string refusal = ": cannot be written: Permission denied";
  EXPECT_EQ(error_of([&] { write_file(path("file"), "x"); }), path("file") + refusal);
  EXPECT_EQ(error_of([&] { check_output(path("file")); }), path("file") + refusal);
  chmod(path("file").c_str(), 0644);
  chmod(directory_.path().c_str(), 0555);
  EXPECT_EQ(error_of([&] { write_file(path("file"), "x"); }), path("file") + refusal);
  EXPECT_EQ(error_of([&] { check_output(path("file")); }), path("file") + refusal);
  chmod(directory_.path().c_str(), 0755);
  EXPECT_EQ(read("file"), "old");
}

/// Anybody may write such a file, and its owner alone replaces it: that shows before the work.
TEST_F(OutputFiles, AFileOfAnotherUserInASharedFolderIsRefusedBeforehand) {
  const tests::TemporaryDirectory shared;
  if (geteuid() != 0) GTEST_SKIP() << "needs two users";
  chmod(shared.path().c_str(), 01777);
  shared.write("file", "old");
  chmod(shared.path("file").c_str(), 0666);
  const pid_t child = fork();
  if (child == 0) {
    const bool is_changed = setegid(65534) == 0 && seteuid(65534) == 0;
    const std::string expected =
        shared.path("file") + ": cannot be written: Operation not permitted";
    const bool is_refused = error_of([&] { check_output(shared.path("file")); }) == expected &&
                            error_of([&] { write_file(shared.path("file"), "x"); }) == expected;
    _exit(is_changed && is_refused ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(fs::file_size(shared.path("file")), 3u);
}

/// The first is a child's who dies, as a handler that runs in it would; its parent's files stay.
TEST_F(OutputFiles, SignalHandlersRemoveThoseOfTheirProcess) {
  OutputFile a(path("a"));
  OutputFile b(path("b"));
  EXPECT_EQ(names().size(), 2u);
  const pid_t child = fork();
  if (child == 0) {
    remove_temporary_files();
    _exit(0);
  }
  ASSERT_GT(child, 0);
  waitpid(child, nullptr, 0);
  EXPECT_EQ(names().size(), 2u);
  b.finish();
  remove_temporary_files();
  EXPECT_EQ(names(), Names{"b"}) << "what is finished is no temporary file any more";
}

TEST_F(OutputFiles, ManyAtATime) {
  {
    std::vector<std::unique_ptr<OutputFile>> files;
    for (int i = 0; i < 40; ++i) {
      files.push_back(std::make_unique<OutputFile>(path(std::to_string(i))));
      files.back()->append(std::to_string(i));
    }
    for (int i = 0; i < 40; i += 2)
      files[static_cast<std::size_t>(i)]->finish();
  }
  EXPECT_EQ(names().size(), 20u);
  EXPECT_EQ(read("38"), "38");
}

}  // namespace
}  // namespace graze::files
