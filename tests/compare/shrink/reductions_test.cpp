// What is offered in the place of a number is shorter, and a number.

#include <graze/engine/compare/judge/shrink/reductions.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace graze::compare {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

TEST(Reductions, ShorterNumbersAreFiniteAndNearer) {
  for (const double value :
       {0.1, -3.7, 1e-320, 1e300, kLargest, -kLargest, std::nextafter(kLargest, 0.0)}) {
    std::vector<double> offered;
    shorten(value, [&](double coarse) {
      offered.push_back(coarse);
      return false;
    });
    ASSERT_FALSE(offered.empty());
    EXPECT_EQ(offered.front(), 0);
    for (std::size_t i = 0; i < offered.size(); ++i) {
      EXPECT_TRUE(std::isfinite(offered[i])) << value;
      if (i > 0) {
        EXPECT_LE(std::abs(offered[i] - value), std::abs(offered[i - 1] - value)) << value;
      }
    }
  }
}

}  // namespace
}  // namespace graze::compare
