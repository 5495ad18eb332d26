#include <graze/engine/mesh/io/output_file.h>
#include <graze/engine/mesh/mesh_error.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/files/temporary_directory.h"

namespace graze::mesh_io {
namespace {

using tests::TemporaryDirectory;

TEST(OutputFile, HoldsWhatWasAppendedAcrossItsBuffer) {
  const TemporaryDirectory directory;
  std::string expected;
  {
    OutputFile file(directory.path("a"));
    for (std::size_t length : {0u, 1u, 65535u, 65536u, 65537u, 200000u}) {
      const std::string part(length, static_cast<char>('a' + length % 26));
      file.append(part);
      expected += part;
    }
    file.finish();
  }
  std::ifstream file(directory.path("a"), std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), expected);
}

TEST(OutputFile, IsRemovedUnlessFinished) {
  const TemporaryDirectory directory;
  {
    OutputFile file(directory.path("a"));
    file.append("half");
    EXPECT_TRUE(std::filesystem::exists(directory.path("a")));
  }
  EXPECT_FALSE(std::filesystem::exists(directory.path("a")));
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

/// A link's target goes, the link stays: what is half written must not be taken for whole.
TEST(OutputFile, AFailedWriteIsTypedAndLeavesNothing) {
  const TemporaryDirectory directory;
  directory.write("real", "");
  std::filesystem::create_symlink(directory.path("real"), directory.path("link"));
  std::string message;
  {
    const FileSizeLimit limit(100000);
    try {
      OutputFile file(directory.path("link"));
      file.append(std::string(300000, 'x'));
      file.finish();
    } catch (const MeshError& error) {
      message = error.what();
    }
  }
  EXPECT_EQ(message, directory.path("link") + ": cannot be written: File too large");
  EXPECT_FALSE(std::filesystem::exists(directory.path("real")));
  EXPECT_TRUE(std::filesystem::is_symlink(directory.path("link")));
}

}  // namespace
}  // namespace graze::mesh_io
