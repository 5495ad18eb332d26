#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

#include <graze/engine/cases/case.h>

namespace graze::tests {

struct FailedCaseSettings {
  std::filesystem::path folder = {};  ///< empty: failed_cases in the build's folder
  std::size_t limit = 8;              ///< so many files of one test
  /// How many failures there were; by default those of the running test.
  std::function<std::size_t()> count_failures = {};
};

/// Keeps what failed: if anything fails while this lives, the query becomes a case, a file named
/// after the test, and the command that replays it is printed. Holds for checks that go on after
/// a failure, EXPECT_...; a query costs nothing while all is well.
///
///   const CaseOnFailure keep([&] { return to_case(a, b, expected); });
///   EXPECT_EQ(find_triangle_pairs(a, b), expected);
///
/// The answer in the case is what was expected, and its witness should say who expects it.
class CaseOnFailure {
 public:
  explicit CaseOnFailure(std::function<Case()> make, FailedCaseSettings settings = {});
  ~CaseOnFailure();
  CaseOnFailure(const CaseOnFailure&) = delete;
  CaseOnFailure& operator=(const CaseOnFailure&) = delete;

 private:
  std::function<Case()> make_;
  FailedCaseSettings settings_;
  std::size_t before_;
};

/// The case as one that brute force has answered.
Case by_brute_force(Case query);

}  // namespace graze::tests
