// `graze pair --check fcl` in a build without FCL.

#include "tests/engine/cli/command_test.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::tests {
namespace {

class CliWithoutFcl : public CommandTest {};

TEST_F(CliWithoutFcl, ACheckIsRefusedNotSkipped) {
  write_mesh("box.off", make_box({1, 1, 1}));
  expect_refusal({"pair", "box.off", "box.off", "--check", "fcl"},
                 "graze: --check fcl: this command was built without FCL");
}

}  // namespace
}  // namespace graze::tests
