// Where contacts stand: point_a on A's surface and point_b on B's, the depth apart along the
// normal, and the point midway. Of every pair of kinds, in general position and in the positions
// that scenes are made of: faces flush, edges that nearly coincide, equal shapes stacked,
// concentric and deep.

#include <graze/engine/world/manifold.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/engine/world/random_shapes.h"
#include "tests/engine/world/surface_distance.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/shape_kinds.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::at;
using tests::outside_by;
using tests::random_pose;
using tests::random_shape;
using tests::reach_along;
using tests::size_of;
using tests::Surface;

struct Placed {
  Shape shape;
  Pose pose;
};

bool is_solid(const Shape& shape) {
  return shape.kind() != ShapeKind::Mesh;
}

bool is_rounded(const Shape& shape) {
  return shape.kind() == ShapeKind::Sphere || shape.kind() == ShapeKind::Capsule;
}

/// Shapes whose edges count against faces by a twentieth, if one of the two is a box.
bool is_flat(const Shape& shape) {
  return shape.kind() == ShapeKind::Box || shape.kind() == ShapeKind::Mesh;
}

/// The contact of a point that is of no corner, edge or face.
bool is_single(const ContactFeature& feature) {
  constexpr std::uint64_t kSingle = 0x30000;
  return (feature.a & 0xffffffff) == kSingle && (feature.b & 0xfffffff) == kSingle;
}

/// What find_contacts() promises of every contact.
void expect_on_both(const Placed& a, const Placed& b, const std::string& label) {
  Work work;
  const Manifold m = find_contacts({a.shape, a.pose}, {b.shape, b.pose}, &work);
  const Surface of_a(a.shape), of_b(b.shape);
  const double size_a = size_of(a.shape), size_b = size_of(b.shape);
  const double between = (a.pose.translation() - b.pose.translation()).norm();
  const double bound = 0x1p-32 * (size_a + size_b + between) +
                       0x1p-50 * (a.pose.translation().norm() + b.pose.translation().norm());
  const bool is_of_boxes = is_flat(a.shape) && is_flat(b.shape);
  const bool is_of_meshes = !is_solid(a.shape) && !is_solid(b.shape);
  for (const ShapeContact& c : m) {
    const double from_a = of_a.distance(a.pose, c.point_a);
    const double from_b = of_b.distance(b.pose, c.point_b);
    // Of two meshes one of the points may be on the plane of a face.
    EXPECT_LE(is_of_meshes ? std::min(from_a, from_b) : std::max(from_a, from_b), bound)
        << label << " feature " << std::hex << c.feature.a << " " << c.feature.b;
    EXPECT_EQ(c.point, Vector3d(0.5 * (c.point_a + c.point_b))) << label;
    EXPECT_NEAR(c.normal.norm(), 1, 1e-12) << label;
    // What lies in each other's surfaces has the points of its intersection.
    if (is_of_meshes && c.point_a == c.point_b) continue;
    double allowed = bound;
    if (is_single(c.feature)) {
      allowed += 0x1p-17 * std::min(size_a, size_b) + (is_of_boxes ? 0.05 * c.depth : 0);
      if (is_rounded(a.shape) || is_rounded(b.shape))
        allowed += 0x1p-16 * (size_a + size_b + between);
      if (work.penetration_failures != 0) allowed += c.depth;
    }
    EXPECT_LE((c.point_a - c.point_b - c.depth * c.normal).norm(), allowed)
        << label << " feature " << std::hex << c.feature.a << " " << c.feature.b << " depth "
        << c.depth;
    // There A ends and B begins.
    const Vector3d beyond = 1e-3 * std::min(size_a, size_b) * c.normal;
    if (is_solid(a.shape)) {
      EXPECT_GE(outside_by(a.shape, a.pose, c.point_a + beyond), -allowed) << label;
    }
    if (is_solid(b.shape)) {
      EXPECT_GE(outside_by(b.shape, b.pose, c.point_b - beyond), -allowed) << label;
    }
  }
}

template <typename Check>
void for_each_pair_of_kinds(Check&& check) {
  for (const ShapeKind kind_a : tests::kOwnKinds) {
    for (const ShapeKind kind_b : tests::kOwnKinds) {
      if (kind_a == ShapeKind::HalfSpace && kind_b == kind_a) continue;
      check(kind_a, kind_b, std::string(name_of(kind_a)) + "/" + name_of(kind_b) + " ");
    }
  }
}

void hunt_in_general_position(std::uint64_t seed, int count) {
  RandomSource source(seed);
  for_each_pair_of_kinds([&](ShapeKind kind_a, ShapeKind kind_b, const std::string& label) {
    for (int n = 0; n < count && !testing::Test::HasFailure(); ++n) {
      const Placed a{random_shape(kind_a, 1, source), random_pose(1, source)};
      Placed b{random_shape(kind_b, 1, source), random_pose(1, source)};
      const double away = source.uniform(0, 0.8) * (size_of(a.shape) + size_of(b.shape));
      b.pose.translation() =
          a.pose.translation() + source.vector(-1, 1).normalized() * away * source.uniform(0, 1);
      expect_on_both(a, b, label + std::to_string(n));
    }
  });
}

/// Shapes of equal and of commensurable sizes, as parts of machines have them; and long ones.
std::vector<Shape> standard_shapes(ShapeKind kind) {
  const std::vector<Vector3d> cube{{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                                   {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};
  const std::vector<Vector3d> wedge{{-1, -1, -1}, {1.5, -1, -1}, {-1, 0.5, -1}, {-1, -1, 1}};
  switch (kind) {
    case ShapeKind::Sphere:
      return {Sphere{{0, 0, 0}, 1}, Sphere{{0, 0, 0}, 0.25}};
    case ShapeKind::Box:
      return {Box{{1, 1, 1}}, Box{{1, 1, 1}}, Box{{2, 1, 0.5}}, Box{{0.1, 4, 0.1}}};
    case ShapeKind::Capsule:
      return {Capsule{1, 1}, Capsule{0.5, 1}, Capsule{0.1, 4}};
    case ShapeKind::Cylinder:
      return {Cylinder{1, 1}, Cylinder{0.5, 1}, Cylinder{0.1, 4}};
    case ShapeKind::Cone:
      return {Cone{1, 1}, Cone{0.5, 1}, Cone{0.1, 4}};
    case ShapeKind::Ellipsoid:
      return {Ellipsoid{{0, 0, 0}, {1, 1, 1}}, Ellipsoid{{0, 0, 0}, {1, 0.5, 0.25}}};
    case ShapeKind::ConvexHull:
      return {ConvexHull(cube), ConvexHull(wedge)};
    case ShapeKind::HalfSpace:
      return {HalfSpace{{0, 0, 1}, 0}};
    default:
      return {tests::make_box({1, 1, 1}), tests::make_sphere(1, 5, 8)};
  }
}

Eigen::Matrix3d standard_turn(RandomSource& source) {
  const auto quarter = [&] { return std::acos(0.0) * source.integer(0, 3); };
  Eigen::Matrix3d turn;
  turn = Eigen::AngleAxisd(quarter(), Vector3d::UnitX()) *
         Eigen::AngleAxisd(quarter(), Vector3d::UnitY());
  if (source.integer(0, 2) == 0) turn = turn * Eigen::AngleAxisd(0.7854, Vector3d::UnitZ());
  return turn;
}

template <typename Item>
Item any_of(const std::vector<Item>& items, RandomSource& source) {
  return items[static_cast<std::size_t>(source.integer(0, static_cast<int>(items.size()) - 1))];
}

/// B beside A along an axis, a diagonal or nothing, that deep, a part of a 256th of its size off
/// the line through both, and jittered.
void hunt_in_special_position(std::uint64_t seed, int count) {
  RandomSource source(seed);
  const std::vector<double> depths{0, 1e-12, 1e-9, 1e-6, 1e-3, 0.05, 0.4};
  const std::vector<double> jitters{0, 0, 1e-15, 1e-9, 1e-6, 1e-4, 3e-3, 0.015, 0.1};
  const std::vector<double> shifts{0, 0, 1e-9, 1e-3, 0x1p-9, 0x1p-8, 0x1.8p-8, 0.3, 1};
  for_each_pair_of_kinds([&](ShapeKind kind_a, ShapeKind kind_b, const std::string& label) {
    const std::vector<Shape> all_a = standard_shapes(kind_a), all_b = standard_shapes(kind_b);
    for (int n = 0; n < count && !testing::Test::HasFailure(); ++n) {
      Placed a{any_of(all_a, source), at(0)};
      Placed b{any_of(all_b, source), at(0)};
      a.pose.linear() = standard_turn(source);
      b.pose.linear() = standard_turn(source);
      Vector3d way = source.integer(0, 4) == 0
                         ? source.lattice_point(-1, 1)
                         : Vector3d::Unit(static_cast<int>(source.integer(0, 2)));
      const Vector3d shift = source.lattice_point(-1, 1) * any_of(shifts, source);
      if (kind_a == ShapeKind::HalfSpace) way = a.pose.linear().col(2);
      if (kind_b == ShapeKind::HalfSpace) way = -b.pose.linear().col(2);
      if (way.norm() > 0) way.normalize();
      if (way.norm() > 0 && source.integer(0, 9) != 0) {
        const double reach = reach_along(a.shape, a.pose, way) + reach_along(b.shape, b.pose, -way);
        b.pose.translation() = way * (reach - any_of(depths, source));
      }
      b.pose.translation() += shift - way * way.dot(shift);
      const double jitter = any_of(jitters, source);
      b.pose.translation() += source.vector(-jitter, jitter);
      b.pose.linear() =
          Eigen::AngleAxisd{source.uniform(-jitter, jitter), source.vector(-1, 1).normalized()}
              .toRotationMatrix() *
          b.pose.linear();
      if (source.integer(0, 1) == 0) {
        const Pose world = random_pose(10, source);
        a.pose = world * a.pose;
        b.pose = world * b.pose;
      }
      expect_on_both(a, b, label + std::to_string(n));
    }
  });
}

TEST(ContactPoints, InGeneralPosition) {
  hunt_in_general_position(51, 24);
}

TEST(ContactPoints, InSpecialPosition) {
  hunt_in_special_position(52, 60);
}

/// The upper face of a cube of triangles lies a part of a millionth below a hull's lower one, leans
/// as little, and ends a hundredth beside it: where the two touch last is found by steps, of which
/// the last may leave a billionth.
TEST(ContactPoints, OfAFaceThatLeansByAHair) {
  Pose pose_a = at(0);
  pose_a.linear() << -0x1p-52, 0, -1, 0, 1, 0, 1, 0, -0x1p-52;
  Pose pose_b = at({-8.5421735728168756e-07, 0.0058586268515455082, 2.0000004901804482});
  pose_b.linear() << -0.99999999999987466, -3.1557899141676738e-07, -3.8881563091995119e-07,
      3.1557909124075949e-07, -0.99999999999991729, -2.5680365231801898e-07,
      -3.8881554989861229e-07, -2.5680377498898545e-07, 0.99999999999989142;
  const Shape hull = standard_shapes(ShapeKind::ConvexHull).front();
  expect_on_both({hull, pose_a}, {tests::make_box({1, 1, 1}), pose_b}, "leans");
}

TEST(ContactPointsSlow, InGeneralPosition) {
  for (std::uint64_t seed = 1; seed < 40; ++seed)
    hunt_in_general_position(seed << 8, 50);
}

TEST(ContactPointsSlow, InSpecialPosition) {
  for (std::uint64_t seed = 1; seed < 40; ++seed)
    hunt_in_special_position(seed << 8, 200);
}

/// B is so much larger than A that rounding of its points is more than a millionth of A, and moved
/// in from where it touches: by less than A's size, or by a share of its own.
void hunt_beside_giants(std::uint64_t seed, int count) {
  RandomSource source(seed);
  for_each_pair_of_kinds([&](ShapeKind kind_a, ShapeKind kind_b, const std::string& label) {
    if (kind_a >= ShapeKind::HalfSpace || kind_b >= ShapeKind::HalfSpace) return;
    for (int n = 0; n < count && !testing::Test::HasFailure(); ++n) {
      const double ratio = std::pow(10.0, source.uniform(6, 12));
      const Placed a{random_shape(kind_a, 1, source), random_pose(0, source)};
      Placed b{random_shape(kind_b, ratio, source), random_pose(0, source)};
      if (n % 2 == 0) b.pose.linear().setIdentity();
      const Vector3d way = n % 3 == 0
                               ? Vector3d(Vector3d::Unit(static_cast<int>(source.integer(0, 2))))
                               : source.vector(-1, 1).normalized();
      const double reach = reach_along(a.shape, a.pose, way) + reach_along(b.shape, b.pose, -way);
      const double depth = std::pow(10.0, source.uniform(-6, n % 4 == 0 ? std::log10(ratio) : 0));
      b.pose.translation() = way * (reach - depth);
      expect_on_both(a, b, label + std::to_string(n));
      expect_on_both(b, a, "swapped " + label + std::to_string(n));
    }
  });
}

TEST(ContactPoints, OfShapesBesideGiants) {
  hunt_beside_giants(54, 24);
}

TEST(ContactPointsSlow, OfShapesBesideGiants) {
  for (std::uint64_t seed = 1; seed < 40; ++seed)
    hunt_beside_giants(seed << 8, 50);
}

/// Stacks of boxes that are nearly flush: what slides onto an edge is on both all the same.
TEST(ContactPoints, OfBoxesThatAreNearlyFlush) {
  RandomSource source(53);
  for (int n = 0; n < 2000 && !HasFailure(); ++n) {
    const double jitter = 0x1p-8 * source.uniform(0, 1.5) * source.uniform(0, 1);
    const Placed a{Box{{0.5, 0.5, 0.5}}, random_pose(1, source)};
    Placed b = a;
    b.pose = a.pose * at({source.uniform(-jitter, jitter), source.uniform(-jitter, jitter),
                          0.999 + source.uniform(-jitter, 0)});
    b.pose.rotate(
        Eigen::AngleAxisd{source.uniform(-jitter, jitter), source.vector(-1, 1).normalized()});
    expect_on_both(a, b, "boxes " + std::to_string(n));
  }
}

/// The edges whose product is the way out pass each other beyond an end of the one, as another such
/// way is a little shorter: the points of these edges that are nearest would be a fifth of the
/// depth beside each other.
TEST(ContactPoints, OfEdgesThatPassBeyondAnEnd) {
  Placed cube{Box{{1, 1, 1}}, at(0)};
  cube.pose.linear() << -0x1.411c544904c05p-1, 0x1.8e63b908956c4p-1, 0x1.1d31867b561cp-5,
      0x1.b61db44db96b1p-3, 0x1.08681b90929bfp-3, 0x1.efc28e9670479p-1, 0x1.7f73ae049966p-1,
      0x1.3abd104cde2f6p-1, -0x1.faba52bc4bc7bp-3;
  Placed rod{Box{{0.1, 4, 0.1}}, at(0)};
  cube.pose.translation() =
      Vector3d(-0x1.39e00ddf8312p+3, 0x1.f3f8fc9d3b0d4p+2, -0x1.0fa9053ce82f5p+3);
  rod.pose.linear() << -0x1.0d7adde886f28p-3, 0x1.fb82750614c04p-1, 0x1.912d30c04da66p-7,
      -0x1.46e51fc0f853bp-2, -0x1.f6a1959e575e4p-6, -0x1.e4f4b3db46a3dp-1, -0x1.e082a655a2fc3p-1,
      -0x1.07400b6a7facdp-3, 0x1.48295fe3b9086p-2;
  rod.pose.translation() =
      Vector3d(-0x1.3c49fa35dd0eep+3, 0x1.b2f513fd2edfdp+2, -0x1.0a1ae94dd40fap+3);
  ASSERT_FALSE(find_contacts({cube.shape, cube.pose}, {rod.shape, rod.pose}).empty());
  expect_on_both(cube, rod, "cube/rod");
  expect_on_both(rod, cube, "rod/cube");
}

/// A thin plate and a small box aslant in its rim, poses as a robot's planner met them. Two edges
/// would part them sooner than the rim's face does, but by less than a twentieth: so the box's
/// deepest corner is not over that face, and half the depth from the contact between, along the
/// normal, there is neither surface, by 0.09 mm.
TEST(ContactPoints, OfABoxThatIsDeepestBesideAFace) {
  const Placed plate{Box{{0.23, 0.24, 0.005}}, at(-0.721, -0.772, 0.81)};
  Placed box{Box{{0.0247605, 0.073, 0.03625}},
             at(-0.42677133002999479, -0.76596851247746789, 0.80746731400091054)};
  box.pose.linear() << 0.10758262492983037, -0.66248818500152129, -0.74130653817877357,
      0.22682184885125473, -0.709614040775253474, 0.66708302483147863, -0.96797615037608542,
      -0.23991106241273435, 0.07392465377049165;
  const Manifold m = find_contacts({plate.shape, plate.pose}, {box.shape, box.pose});
  ASSERT_FALSE(m.empty());
  const Vector3d apart = m[0].point_a - m[0].point_b;
  EXPECT_GT(apart.cross(m[0].normal).norm(), 1e-5);
  EXPECT_NEAR(apart.dot(m[0].normal), m[0].depth, 0.05 * m[0].depth);
  expect_on_both(plate, box, "plate/box");
  expect_on_both(box, plate, "box/plate");
}

/// They graze each other in one point, where the search for what is nearest leaves two points that
/// are apart by ten times what counts as touching: each is on the surface that it is said to be on.
TEST(ContactPoints, OfAHullThatGrazesAMesh) {
  Pose of_hull = Pose::Identity(), of_mesh = Pose::Identity();
  of_hull.linear() << -0x1.6c23c94c734c3p-4, -0x1.c59fc65ab1cabp-3, -0x1.f13412be66625p-1,
      -0x1.3ce365f54c2d2p-2, 0x1.dd9eeaeebab17p-1, -0x1.79bccfabf68bbp-3, 0x1.e4bc0d903d498p-1,
      0x1.22f08d01d60fbp-2, -0x1.363939216037ep-3;
  of_hull.translation() =
      Vector3d(0x1.a485ab1b37662p+1, 0x1.2b47fc3c5e944p+2, -0x1.4b4b040a8edd4p+2);
  of_mesh.linear() << 0x1.3f63bfaa2bb03p-1, -0x1.7fc31948c38e6p-1, 0x1.c59fa9aba01b7p-3,
      -0x1.6a1839dbbd7c4p-4, -0x1.659fa50f5d134p-2, -0x1.dd9ef1fa11b02p-1, 0x1.8d998e45fa28bp-1,
      0x1.1feb19fcf7998p-1, -0x1.22f069ee4b0cdp-2;
  of_mesh.translation() =
      Vector3d(0x1.899cbd472b8a1p+1, 0x1.f7c550e65cd82p+1, -0x1.71b238709bd91p+1);
  int grazing = 0;
  for (const Shape& hull : standard_shapes(ShapeKind::ConvexHull)) {
    for (const Shape& mesh : standard_shapes(ShapeKind::Mesh)) {
      grazing += find_contacts({hull, of_hull}, {mesh, of_mesh}).size() == 1;
      expect_on_both({hull, of_hull}, {mesh, of_mesh}, "hull/mesh");
      expect_on_both({mesh, of_mesh}, {hull, of_hull}, "mesh/hull");
    }
  }
  EXPECT_GT(grazing, 0);
}

}  // namespace
}  // namespace graze
