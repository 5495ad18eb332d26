// What the command does when graze is found to be wrong. The real referee never finds that, so this
// program has a judge who lies.

#include <graze/engine/cli/pair/fcl_check.h>
#include <graze/engine/cli/pair/pair_job.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <string>

#include "tests/files/temporary_directory.h"

namespace graze::cli {
namespace {

/// Finds graze wrong on every pose with pair (7, 9), which FCL is said to miss.
class LyingCheck : public FclCheck {
 public:
  compare::Comparison check_pairs(const TrianglePairs& graze_pairs, const Pose&,
                                  const Pose&) const override {
    return verdict(!graze_pairs.empty());
  }
  compare::Comparison check_any(bool graze_intersects, const Pose&, const Pose&) const override {
    return verdict(graze_intersects);
  }

 private:
  static compare::Comparison verdict(bool graze_intersects) {
    compare::Comparison comparison;
    comparison.graze_intersects = graze_intersects;
    comparison.differences = {{{7, 9}, true, false, false}};
    comparison.graze_wrong = 1;
    return comparison;
  }
};

}  // namespace

bool has_fcl_check() {
  return true;
}

std::unique_ptr<FclCheck> make_fcl_check(const Mesh&, const Mesh&) {
  return std::make_unique<LyingCheck>();
}

namespace {

class CliVerdict : public testing::Test {
 protected:
  CliVerdict() {
    options_.mesh_a = options_.mesh_b =
        directory_.write("mesh.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    options_.check = "fcl";
  }
  ~CliVerdict() override { std::fclose(stream_); }

  std::string written() {
    std::string text(static_cast<std::size_t>(std::ftell(stream_)), ' ');
    std::rewind(stream_);
    EXPECT_EQ(std::fread(text.data(), 1, text.size(), stream_), text.size());
    return text;
  }

  tests::TemporaryDirectory directory_;
  std::FILE* stream_ = std::tmpfile();
  Output output_ = Output(stream_);
  PairOptions options_;
};

TEST_F(CliVerdict, AWrongAnswerIsExitCodeOne) {
  EXPECT_EQ(run_pair(options_, output_), ExitCode::GrazeWrong);
  EXPECT_NE(written().find("triangles 7 and 9: graze says yes, fcl says no, truth is no"),
            std::string::npos);
}

TEST_F(CliVerdict, AWrongBooleanAnswerToo) {
  options_.query = "any";
  EXPECT_EQ(run_pair(options_, output_), ExitCode::GrazeWrong);
}

TEST_F(CliVerdict, JsonCarriesTheDifference) {
  options_.is_json = true;
  EXPECT_EQ(run_pair(options_, output_), ExitCode::GrazeWrong);
  EXPECT_NE(written().find("\"fcl\":{\"intersects\":false,\"pairs\":0,\"differences\":"
                           "[{\"pair\":[7,9],\"graze\":true,\"fcl\":false,\"truth\":false}],"
                           "\"graze_wrong\":1,\"fcl_wrong\":0}}\n"),
            std::string::npos);
}

TEST_F(CliVerdict, WithoutACheckNothingIsWrong) {
  options_.check.clear();
  EXPECT_EQ(run_pair(options_, output_), ExitCode::Answered);
}

}  // namespace
}  // namespace graze::cli
