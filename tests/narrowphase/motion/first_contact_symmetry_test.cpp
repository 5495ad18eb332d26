// Law 12 over what changes nothing: orders, mirrors, scales; and the same paths the other way.

#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/first_contact.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/narrowphase/motion/random_paths.h"
#include "tests/narrowphase/motion/rational_contact.h"

namespace graze {
namespace {

using tests::PathQuery;

constexpr StartContact kStarts[] = {StartContact::Counts, StartContact::IsLeft};
constexpr int kWholeRange[] = {10, 11};  // whose exact stages, and the oracle, take long

bool is_of_whole_range(int kind) {
  return kind == kWholeRange[0] || kind == kWholeRange[1];
}

template <typename Change>
PathQuery changed(PathQuery query, const Change& change) {
  for (PointPath& path : query.path)
    path = {change(path.start), change(path.end)};
  return query;
}

PathQuery reversed(PathQuery query) {
  for (PointPath& path : query.path)
    std::swap(path.start, path.end);
  return query;
}

class Law12Symmetry : public testing::TestWithParam<int> {};

TEST_P(Law12Symmetry, OrdersChangeNothing) {
  RandomSource source(17);
  for (int n = 0; n < (is_of_whole_range(GetParam()) ? 3 : 100); ++n) {
    const PathQuery query = tests::random_paths(GetParam(), source);
    for (StartContact start : kStarts) {
      const FirstContactSettings settings{.start = start};
      const TrianglePath t = query.triangle();
      const auto point = first_contact(query.point(), t, settings);
      ASSERT_EQ(first_contact(query.point(), TrianglePath{t.b, t.c, t.a}, settings), point);
      ASSERT_EQ(first_contact(query.point(), TrianglePath{t.c, t.b, t.a}, settings), point);
      const EdgePath a = query.edge_a(), b = query.edge_b();
      const auto edges = first_contact(a, b, settings);
      ASSERT_EQ(first_contact(b, a, settings), edges);
      ASSERT_EQ(first_contact(EdgePath{a.b, a.a}, b, settings), edges);
      ASSERT_EQ(first_contact(a, EdgePath{b.b, b.a}, settings), edges);
    }
  }
}

TEST_P(Law12Symmetry, MirrorsTurnsAndScalesChangeNothing) {
  RandomSource source(18);
  for (int n = 0; n < (is_of_whole_range(GetParam()) ? 3 : 60); ++n) {
    const PathQuery query = tests::random_paths(GetParam(), source);
    const auto same = [&](const PathQuery& other) {
      return first_contact(other.point(), other.triangle()) ==
                 first_contact(query.point(), query.triangle()) &&
             first_contact(other.edge_a(), other.edge_b()) ==
                 first_contact(query.edge_a(), query.edge_b());
    };
    ASSERT_TRUE(same(changed(query, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return {-p.x(), p.y(), p.z()};
    })));
    ASSERT_TRUE(same(changed(query, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return {p.y(), p.z(), -p.x()};
    })));
    if (GetParam() >= 10 && GetParam() <= 12) continue;  // near both ends of the range already
    ASSERT_TRUE(same(changed(query, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return {std::ldexp(p.x(), 300), std::ldexp(p.y(), -500), std::ldexp(p.z(), 40)};
    })));
  }
}

// There is a contact going forth if there is one going back, at the times of the same contacts.
TEST_P(Law12Symmetry, TheWayBackMeetsTheSameContacts) {
  RandomSource source(19);
  for (int n = 0; n < (is_of_whole_range(GetParam()) ? 3 : 100); ++n) {
    const PathQuery query = tests::random_paths(GetParam(), source), back = reversed(query);
    const auto forth_point = first_contact(query.point(), query.triangle());
    const auto back_point = first_contact(back.point(), back.triangle());
    ASSERT_EQ(forth_point.has_value(), back_point.has_value());
    if (forth_point) {
      ASSERT_LE(forth_point->time, 1 - back_point->time + 0x1p-53);
    }
    const auto forth_edges = first_contact(query.edge_a(), query.edge_b());
    const auto back_edges = first_contact(back.edge_a(), back.edge_b());
    ASSERT_EQ(forth_edges.has_value(), back_edges.has_value());
    if (forth_edges) {
      ASSERT_LE(forth_edges->time, 1 - back_edges->time + 0x1p-53);
    }
  }
}

Triangle start_of(const TrianglePath& path) {
  return {path.a.start, path.b.start, path.c.start};
}

/// The first of all corners with the other triangle and all pairs of edges, by rational arithmetic.
std::optional<FirstContact> first_of_features(const TrianglePath& a, const TrianglePath& b,
                                              StartContact start) {
  const bool is_hit = start == StartContact::Counts ? intersects(start_of(a), start_of(b))
                                                    : crosses(start_of(a), start_of(b));
  if (is_hit) return FirstContact{0, true};
  std::optional<FirstContact> first;
  const auto take = [&](const std::optional<FirstContact>& contact) {
    if (contact && (!first || contact->time < first->time)) first = contact;
  };
  const PointPath corner_a[3] = {a.a, a.b, a.c}, corner_b[3] = {b.a, b.b, b.c};
  for (int i = 0; i < 3; ++i) {
    take(oracle::rational_first_contact(corner_a[i], b, start));
    take(oracle::rational_first_contact(corner_b[i], a, start));
    for (int k = 0; k < 3; ++k)
      take(oracle::rational_first_contact(EdgePath{corner_a[i], corner_a[(i + 1) % 3]},
                                          EdgePath{corner_b[k], corner_b[(k + 1) % 3]}, start));
  }
  return first;
}

TEST_P(Law12Symmetry, TwoTrianglesMeetWhereTheirFeaturesDo) {
  RandomSource source(20);
  for (int n = 0; n < (is_of_whole_range(GetParam()) ? 0 : 12); ++n) {
    const PathQuery query = tests::random_paths(GetParam(), source);
    const PathQuery other = tests::random_paths(GetParam(), source);
    const TrianglePath a = query.triangle(), b{query.path[0], other.path[0], other.path[1]};
    for (StartContact start : kStarts) {
      const FirstContactSettings settings{.start = start};
      const auto contact = first_contact(a, b, settings);
      ASSERT_EQ(contact, first_of_features(a, b, start))
          << oracle::text_of(a) << ", " << oracle::text_of(b) << "\n"
          << oracle::text_of(contact);
      ASSERT_EQ(first_contact(b, TrianglePath{a.c, a.a, a.b}, settings), contact);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllKinds, Law12Symmetry, testing::Range(0, tests::kPathKinds));

}  // namespace
}  // namespace graze
