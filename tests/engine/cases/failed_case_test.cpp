// What fails is kept: a case that can be read and asked again.

#include "tests/files/failed_case.h"

#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/to_case.h>
#include <gtest/gtest.h>

#include "tests/files/temporary_directory.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::tests {
namespace {

class FailedCase : public testing::Test {
 protected:
  /// A query in whose life there are so many failures.
  void ask(std::size_t failures) {
    const CaseOnFailure keep([&] { return by_brute_force(to_case({box_}, {box_}, true)); },
                             {.folder = folder_.path() / "failed",
                              .limit = 2,
                              .count_failures = [this] { return failures_; }});
    failures_ += failures;
  }
  std::filesystem::path file(int number) const {
    return folder_.path() / "failed" /
           ("FailedCase-" +
            std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + "-" +
            std::to_string(number) + ".json");
  }

  TemporaryDirectory folder_;
  Mesh box_ = make_box({1, 1, 1});
  std::size_t failures_ = 3;  // of earlier queries, which are none of this one's business
};

TEST_F(FailedCase, IsNotKeptWhileAllIsWell) {
  ask(0);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "failed"));
}

TEST_F(FailedCase, IsKeptAndCanBeReadAgain) {
  ask(1);
  const Case kept = read_case(file(0));
  EXPECT_EQ(kept.ask, Ask::Any);
  EXPECT_EQ(kept.answer->says, true);
  EXPECT_EQ(kept.answered_by.engine, "brute force");
  EXPECT_EQ(kept.note, "failed in FailedCase-IsKeptAndCanBeReadAgain");
  EXPECT_EQ(std::get<CaseMesh>(kept.a).mesh.vertices().size(), box_.vertices().size());
}

TEST_F(FailedCase, DoesNotFillTheDisk) {
  for (int i = 0; i < 5; ++i)
    ask(2);
  EXPECT_TRUE(std::filesystem::exists(file(1)));
  EXPECT_FALSE(std::filesystem::exists(file(2)));
}

}  // namespace
}  // namespace graze::tests
