#pragma once

#include <graze/engine/mesh/mesh.h>
#include <gtest/gtest.h>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tests/engine/cli/command.h"
#include "tests/files/temporary_directory.h"

namespace graze::tests {

inline constexpr const char* kIdentity = "1 0 0 0 0 1 0 0 0 0 1 0";

/// A folder of its own for each test, with meshes and poses to ask about.
class CommandTest : public testing::Test {
 private:
  TemporaryDirectory directory_;

 protected:
  void write(const std::string& name, std::string_view text) const { directory_.write(name, text); }

  /// As OFF, with all digits.
  void write_mesh(const std::string& name, const Mesh& mesh) const;

  CommandResult graze(const std::vector<std::string>& arguments) const {
    return run_graze(folder_, arguments);
  }

  /// The command refuses: exit code 2, nothing on stdout, and exactly this line on stderr.
  void expect_refusal(const std::vector<std::string>& arguments, const std::string& line) const;

  const std::filesystem::path& folder_ = directory_.path();
};

}  // namespace graze::tests
