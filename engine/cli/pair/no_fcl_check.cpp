// This file takes the place of fcl_check.cpp in builds without FCL.

#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/pair/fcl_check.h>

namespace graze::cli {

bool has_fcl_check() {
  return false;
}

std::unique_ptr<FclCheck> make_fcl_check(const Mesh&, const Mesh&) {
  throw UsageError("--check fcl: this command was built without FCL");
}

}  // namespace graze::cli
