// The referee against CGAL's exact kernel, where that has an answer: triangles with area.

#include <graze/engine/compare/referee.h>
#include <gtest/gtest.h>
#include <tests/oracle/category.h>
#include <tests/oracle/sampler.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

namespace graze::compare {
namespace {

using Kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;

Kernel::Point_3 to_cgal(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

Kernel::Triangle_3 to_cgal(const Triangle& t) {
  return {to_cgal(t.a), to_cgal(t.b), to_cgal(t.c)};
}

void expect_agreement(std::uint64_t step, std::uint64_t count) {
  std::uint64_t asked = 0;
  for (const auto& corpus : oracle::pair_corpora()) {
    for (std::uint64_t i = 0; i < count; ++i) {
      const oracle::TrianglePair pair = corpus.element(i * step);
      const Kernel::Triangle_3 a = to_cgal(pair.a);
      const Kernel::Triangle_3 b = to_cgal(pair.b);
      if (a.is_degenerate() || b.is_degenerate()) continue;
      ++asked;
      ASSERT_EQ(referee_intersects(pair.a, pair.b), CGAL::do_intersect(a, b))
          << corpus.name() << " element " << i * step;
    }
  }
  EXPECT_GT(asked, count * oracle::pair_corpora().size() / 2);
}

TEST(RefereeAgainstCgal, AgreeOnTheCorpora) {
  expect_agreement(89, 40);
}
TEST(RefereeAgainstCgalSlow, AgreeOnAMillionPairs) {
  expect_agreement(1, 1000000 / oracle::pair_corpora().size() * 2);
}

}  // namespace
}  // namespace graze::compare
