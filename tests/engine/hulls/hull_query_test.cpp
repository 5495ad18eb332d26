// Distances, touches and contacts of hulls of every thinness beside the hull by its definition, in
// rational numbers.

#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shapes/hull_data.h>
#include <graze/narrowphase/convex/core/hull.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/engine/hulls/hull_sets.h"
#include "tests/engine/hulls/rational_hull.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::HullSet;
using tests::RationalHull;

/// To which depths are promised, of the smaller shape's size.
constexpr double kDepthTolerance = 1e-6;

// By how much corners slide along faces whose edges coincide.
constexpr double kCoinciding = 0x1p-8;

RationalHull truth_of(const std::vector<Vector3d>& points) {
  std::vector<tests::RationalPoint> exact;
  for (const Vector3d& p : points)
    exact.push_back(tests::rational(p));
  return RationalHull(std::move(exact));
}

struct HullOfSet {
  explicit HullOfSet(int n, RandomSource& source) {
    const double t = tests::random_thinness(source);
    points = tests::hull_points(static_cast<HullSet>(n % tests::kHullSets), t, source);
    if (source.integer(0, 1) == 0) tests::turn(points, source);
  }
  double reach(const Vector3d& d) const {
    double most = -HUGE_VAL;
    for (const Vector3d& p : points)
      most = std::max(most, d.dot(p));
    return most;
  }
  std::vector<Vector3d> points;
};

/// A point near the hull: off a corner, a face or an edge by anything.
Vector3d near_point(const HullOfSet& hull, RandomSource& source) {
  const auto any = [&] {
    return hull.points[static_cast<std::size_t>(
        source.integer(0, static_cast<int>(hull.points.size()) - 1))];
  };
  const double u = source.uniform(0, 1), v = source.uniform(0, 1 - u);
  return any() * u + any() * v + any() * (1 - u - v) +
         source.vector(-1, 1) * std::pow(10.0, source.uniform(-12, 0));
}

TEST(HullQuery, DistancesToBallsAreTheDefinitions) {
  RandomSource source(11);
  int touching = 0, apart = 0, open = 0;
  for (int n = 0; n < 100; ++n) {
    const HullOfSet hull(n, source);
    const RationalHull truth = truth_of(hull.points);
    if (truth.facets().empty()) continue;
    const Shape shape{ConvexHull(hull.points)};
    for (int i = 0; i < 6; ++i) {
      SCOPED_TRACE(testing::Message() << "hull " << n << ", point " << i);
      const Vector3d at = near_point(hull, source);
      const double radius = source.integer(0, 1) == 0 ? 1e-100 : 1e-3;
      const Sphere ball{at, radius};
      const double gap = truth.distance(tests::rational(at)) - radius;
      const double scale = 8;
      const ShapeDistance found = distance({shape, tests::at(0)}, {ball, tests::at(0)});
      const bool is_hit = intersects({shape, tests::at(0)}, {ball, tests::at(0)});
      EXPECT_EQ(is_hit, found.distance == 0);
      EXPECT_LE(found.lower_bound, std::max(gap, 0.0));
      if (!is_hit) {
        EXPECT_GT(gap, 0);
      }
      if (found.status != PairStatus::Converged) {
        ++open;
        continue;
      }
      EXPECT_NEAR(found.distance, std::max(gap, 0.0), kTouchTolerance * scale);
      (gap > 0 ? apart : touching)++;
    }
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(apart, 150);
  EXPECT_GT(touching, 50);
  EXPECT_LT(open, (apart + touching) / 20);
}

/// Each contact lies on both surfaces, and as deep as it says.
TEST(HullQuery, ContactsWithAPlaneAreCornersBelowIt) {
  RandomSource source(12);
  int contacts = 0;
  for (int n = 0; n < 160; ++n) {
    SCOPED_TRACE(n);
    const HullOfSet hull(n, source);
    const RationalHull truth = truth_of(hull.points);
    if (truth.facets().empty()) continue;
    const Shape shape{ConvexHull(hull.points)};
    // Mostly one of the hull's own faces.
    Vector3d up = source.vector(-1, 1).normalized();
    if (n % 4 != 0)
      up = -truth.facets()[static_cast<std::size_t>(n) % truth.facets().size()].unit_normal;
    const double lowest = -hull.reach(-up);
    const double depth = std::pow(10.0, source.uniform(-9, -2));
    const HalfSpace floor{up, lowest + depth};
    const Manifold found = find_contacts({shape, tests::at(0)}, {floor, tests::at(0)});
    ASSERT_FALSE(found.empty());
    EXPECT_NEAR(found[0].depth, depth, kDepthTolerance);
    for (const ShapeContact& contact : found) {
      const Vector3d on_hull = contact.point - up * (0.5 * contact.depth);
      const Vector3d on_floor = contact.point + up * (0.5 * contact.depth);
      EXPECT_NEAR(up.dot(on_floor), lowest + depth, kDepthTolerance);
      EXPECT_LE(truth.distance(tests::rational(on_hull)), kDepthTolerance);
      EXPECT_LE(truth.distance_to_boundary(tests::rational(on_hull)), kDepthTolerance);
      ++contacts;
    }
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(contacts, 300);
}

/// What the two reach past each other along the normal.
double overlap(const HullOfSet& hull, const Vector3d& half, const Vector3d& middle,
               const Vector3d& n) {
  return hull.reach(n) + n.cwiseAbs().dot(half) - n.dot(middle);
}

TEST(HullQuery, ContactsWithABoxPartThem) {
  RandomSource source(13);
  int found_any = 0;
  for (int n = 0; n < 240; ++n) {
    SCOPED_TRACE(n);
    const HullOfSet hull(n, source);
    const RationalHull truth = truth_of(hull.points);
    if (truth.facets().empty()) continue;
    const Shape shape{ConvexHull(hull.points)};
    const Vector3d half = source.vector(0.3, 1.5);
    // Laid onto one of the sides of the box.
    const int k = n % 3;
    const double depth = std::pow(10.0, source.uniform(-9, -2));
    Vector3d middle = source.vector(-0.5, 0.5);
    middle[k] = hull.reach(Vector3d::Unit(k)) + half[k] - depth;
    Work work;
    const Manifold found = find_contacts(
        {shape, tests::at(0)}, {Box{half}, tests::at(middle[0], middle[1], middle[2])}, &work);
    if (found.empty()) continue;
    ++found_any;
    const double size = std::min(half.norm(), 2.0);
    const Vector3d normal = found[0].normal;
    EXPECT_NEAR(normal.norm(), 1, 1e-12);
    const double past = overlap(hull, half, middle, normal);
    EXPECT_NEAR(found[0].depth, past, kDepthTolerance * size + 1e-4);
    EXPECT_LE(found[0].depth, past + 1e-12);
    if (work.penetration_failures == 0) {
      EXPECT_LE(past, depth + 2 * kDepthTolerance * size);
      for (const RationalHull::Facet& facet : truth.facets())
        EXPECT_LE(past,
                  overlap(hull, half, middle, facet.unit_normal) + 2 * kDepthTolerance * size);
    }
    for (const ShapeContact& contact : found) {
      const Vector3d on_hull = contact.point + normal * (0.5 * contact.depth);
      const Vector3d on_box = contact.point - normal * (0.5 * contact.depth);
      const double slide = kCoinciding * size + past;
      EXPECT_LE(truth.distance(tests::rational(on_hull)), slide);
      EXPECT_LE(((on_box - middle).cwiseAbs() - half).maxCoeff(), slide);
      // Not past what supports the hull along the normal, nor the box.
      EXPECT_LE(normal.dot(on_hull), hull.reach(normal) + 2 * kDepthTolerance);
      EXPECT_GE(normal.dot(on_box - middle), -normal.cwiseAbs().dot(half) - 2 * kDepthTolerance);
    }
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(found_any, 120);
}

/// No face that contacts rest on cuts the hull or leaves it, and none is further from it than said.
TEST(HullQuery, FacesForContactsBoundTheHull) {
  RandomSource source(14);
  for (int n = 0; n < 200; ++n) {
    SCOPED_TRACE(n);
    HullOfSet hull(n, source);
    if (truth_of(hull.points).facets().empty()) continue;
    const ConvexHull built(hull.points);
    const narrowphase::Hull& data = data_of(built);
    ASSERT_FALSE(data.contact_faces.empty());
    for (const auto* faces : {&data.faces, &data.contact_faces}) {
      const bool is_exact = faces == &data.faces;
      const auto& loops = is_exact ? data.loops : data.contact_loops;
      const double flatness = is_exact ? 1e-15 : 0x1p-21 * data.bounding_radius + 1e-15;
      for (const auto& face : *faces) {
        ASSERT_GE(face.count, 3u);
        EXPECT_NEAR(length(face.normal), 1, 1e-15);
        double offset = -HUGE_VAL;  // of the plane that holds the hull
        for (const auto& corner : data.corners)
          offset = std::max(offset, dot(face.normal, corner));
        if (is_exact) {
          EXPECT_NEAR(data.offsets[static_cast<std::size_t>(&face - faces->data())], offset, 1e-15);
        }
        for (std::uint32_t i = 0; i < face.count; ++i)
          EXPECT_GE(dot(face.normal, data.corners[loops[face.first + i]]), offset - flatness);
      }
    }
    ASSERT_FALSE(HasFailure());
  }
}

TEST(HullQuery, ABoxRoundedToFloatHasSixFacesForContacts) {
  RandomSource source(15);
  for (int n = 0; n < 100; ++n) {
    std::vector<Vector3d> points;
    const Vector3d half = source.vector(0.2, 1);
    for (int i = 0; i < 8; ++i)
      points.emplace_back(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(),
                          i & 4 ? half.z() : -half.z());
    tests::turn(points, source);
    for (Vector3d& p : points)
      p = p.cast<float>().cast<double>();
    EXPECT_EQ(ConvexHull(points).face_count(), 6u) << n;
  }
}

}  // namespace
}  // namespace graze
