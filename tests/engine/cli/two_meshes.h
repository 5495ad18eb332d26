#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/engine/cli/command_test.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::tests {

/// Poses of the ball.
inline const std::string kApart = "1 0 0 10 0 1 0 0 0 0 1 0";
inline const std::string kCrossing = "1 0 0 1.5 0 1 0 0.25 0 0 1 0.125";

/// A box, a.off, and a ball, b.off.
class TwoMeshes : public CommandTest {
 protected:
  TwoMeshes() {
    write_mesh("a.off", make_box({1, 1, 1}));
    write_mesh("b.off", make_sphere(1, 8, 12));
  }

  /// What `command` prints of them.
  std::string json_of(const char* command, const std::vector<std::string>& options) const {
    std::vector<std::string> arguments = {command, "a.off", "b.off", "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const CommandResult result = graze(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    return result.out;
  }
};

using Keys = std::vector<std::string>;

inline Keys keys_of(const nlohmann::ordered_json& object) {
  Keys keys;
  for (const auto& item : object.items())
    keys.push_back(item.key());
  return keys;
}

}  // namespace graze::tests
