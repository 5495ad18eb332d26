// The configurations that FCL's own tests of shapes ask about, and those of its reports from
// robots: round numbers along axes, stacked boxes, shapes that all but touch. What is true of them
// comes from formulas here, not from FCL. Lengths of capsules, cylinders and cones are halves, as
// the shapes have them.

#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "tests/engine/special_poses/pair_laws.h"
#include "tests/engine/special_poses/pair_text.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::PairLawCounts;
using tests::PlacedPair;

/// A at the origin and B there: apart by `gap`, metres, or that deep in each other, if it is below
/// 0. Shapes that touch have a gap of 0.
struct Known {
  Shape a;
  Shape b;
  Vector3d offset;
  double gap;
  Eigen::AngleAxisd turn = Eigen::AngleAxisd(0, Vector3d::UnitZ());
};

Vector3d along_x(double x) {
  return {x, 0, 0};
}

Vector3d along_z(double z) {
  return {0, 0, z};
}

/// In a few frames: as it stands, and where nothing is round.
std::vector<Pose> frames() {
  RandomSource source(191);
  std::vector<Pose> all{Pose::Identity()};
  for (int n = 0; n < 6; ++n)
    all.push_back(tests::random_pose(10, source));
  return all;
}

void expect_known(const Known& known) {
  for (const Pose& frame : frames()) {
    PlacedPair pair{known.a, known.b, frame, Pose::Identity()};
    pair.pose_b.translation() = known.offset;
    pair.pose_b.linear() = known.turn.toRotationMatrix();
    pair.pose_b = frame * pair.pose_b;
    const bool is_bounded = known.b.kind() != ShapeKind::HalfSpace;
    const double scale =
        is_bounded ? scale_of(pair) : tests::size_about_middle(known.a) + known.offset.norm();
    const double size = std::min(tests::size_about_middle(known.a),
                                 is_bounded ? tests::size_about_middle(known.b) : scale);
    const double touch = kTouchTolerance * scale + 1e-14 * (scale + frame.translation().norm());
    const std::string label = text_of(pair);

    const ShapeDistance found = distance({pair.a, pair.pose_a}, {pair.b, pair.pose_b});
    EXPECT_NEAR(found.distance, std::max(known.gap, 0.0), touch) << label;
    const bool is_hit = intersects({pair.a, pair.pose_a}, {pair.b, pair.pose_b});
    if (std::abs(known.gap) > touch) {
      EXPECT_EQ(is_hit, known.gap < 0) << label;
    }
    const Manifold contacts = find_contacts({pair.a, pair.pose_a}, {pair.b, pair.pose_b});
    ASSERT_EQ(contacts.empty(), !is_hit) << label;
    if (!is_hit) continue;
    EXPECT_NEAR(contacts[0].depth, std::max(-known.gap, 0.0), 1e-6 * size + touch) << label;
  }
}

TEST(KnownConfigurations, BallsBeside) {
  const Shape large = Sphere{{0, 0, 0}, 20}, small = Sphere{{0, 0, 0}, 10};
  for (const double x : {40.0, 30.1, 30.01, 30.0, 29.9, 25.0, 0.0, -29.9, -30.0, -30.01})
    expect_known({large, small, along_x(x), std::abs(x) - 30});
  expect_known({large, small, {20, 0, 20}, std::sqrt(800) - 30});

  const Shape box = Box{{2.5, 2.5, 2.5}};
  for (const double x : {0.0, 22.4, 22.5, 22.501, 22.6, 40.0})
    expect_known({large, box, along_x(x), x - 22.5});
  const Shape capsule = Capsule{5, 5};
  for (const double x : {0.0, 24.9, 25 - 1e-6, 25.0, 25.1, 40.0})
    expect_known({large, capsule, along_x(x), x - 25});
  for (const double x : {40.0, 25.0})
    expect_known({large, Capsule{10, 10}, along_x(x), x - 30});
}

TEST(KnownConfigurations, BoxesBesideBoxes) {
  const Shape large = Box{{10, 20, 25}}, small = Box{{5, 5, 5}};
  for (const double x : {0.0, 15.0, 15.01, 15.1, 20.0})
    expect_known({large, small, along_x(x), x - 15});
  const double angle = 3.14 / 6;
  const Eigen::AngleAxisd turn(angle, Vector3d::UnitZ());
  expect_known({large, small, along_x(0), -(10 + 5 * (std::cos(angle) + std::sin(angle))), turn});
  for (const double x : {10.1, 20.1})
    expect_known({small, small, along_x(x), x - 10});
  expect_known({small, small, {0, 20.2, 0}, 10.2});
  expect_known({small, small, {10.1, 10.1, 0}, 0.1 * std::sqrt(2)});
  // A flat block that reaches into the top of a cube of a hundred.
  expect_known({Box{{50, 50, 50}}, Box{{5, 10, 15}}, along_z(50), -15});

  // An edge of the second is on or in a face of the first.
  const Shape cube = Box{{0.5, 0.5, 0.5}}, block = Box{{0.3, 0.4, 0.5}};
  const Eigen::AngleAxisd aslant(std::atan2(0.8, 0.6), Vector3d::UnitZ());
  for (const double y : {0.0, 0.1, -0.05, -0.1}) {
    expect_known({cube, block, {-1, y, 0}, 0, aslant});
    expect_known({cube, block, {-0.9, y, 0}, -0.1, aslant});
  }
}

TEST(KnownConfigurations, BodiesOfRevolutionBesideEachOther) {
  const Shape cylinder = Cylinder{5, 5}, cone = Cone{5, 5};
  for (const double x : {0.0, 9.9, 10.01, 10.1, 40.0})
    expect_known({cylinder, cylinder, along_x(x), x - 10});
  // At right angles to a cone's side, which rises by two for each that it goes inwards, the way out
  // is shorter than along x.
  const double side = 2 / std::sqrt(5);
  expect_known({cone, cone, along_x(0), -10 * side});
  expect_known({cylinder, cone, along_x(0), -10 * side});
  for (const Shape& other : {cylinder, cone}) {
    expect_known({other, cone, along_x(9.9), -0.1 * side});
    for (const double x : {10.001, 10.01, 10.1, 40.0})
      expect_known({other, cone, along_x(x), x - 10});
    for (const double z : {9.9, 10.01, 40.0})
      expect_known({other, cone, along_z(z), z - 10});
  }
}

TEST(KnownConfigurations, EllipsoidsOnAnAxis) {
  const Shape large = Ellipsoid{{0, 0, 0}, {20, 40, 50}},
              small = Ellipsoid{{0, 0, 0}, {10, 10, 10}};
  for (const double x : {0.0, 29.9, 29.99, 30.0, 30.01, 30.1, 40.0, -29.99, -30.0, -30.01, -40.0})
    expect_known({large, small, along_x(x), std::abs(x) - 30});
}

TEST(KnownConfigurations, ShapesOverHalfSpaces) {
  struct Reach {
    Shape shape;
    Vector3d along;  ///< how far it reaches against each axis
  };
  const Reach reaches[] = {{Sphere{{0, 0, 0}, 10}, {10, 10, 10}},
                           {Box{{2.5, 5, 10}}, {2.5, 5, 10}},
                           {Ellipsoid{{0, 0, 0}, {5, 10, 20}}, {5, 10, 20}},
                           {Capsule{5, 5}, {5, 5, 10}},
                           {Cylinder{5, 5}, {5, 5, 5}},
                           {Cone{5, 5}, {5, 5, 5}}};
  for (const Reach& reach : reaches) {
    for (int k = 0; k < 3; ++k) {
      const Vector3d axis = Vector3d::Unit(k);
      const double most = reach.along(k);
      for (const double at : {0.0, 1.25, -1.25, 2.5, 5.0, most + 0.01, -most - 0.01, -most - 0.1})
        expect_known({reach.shape, HalfSpace{axis, 0}, axis * at, -(most + at)});
    }
  }
}

TEST(KnownConfigurations, ABallAtATriangle) {
  const auto gap_at = [](double x) {
    const std::vector<Vector3d> corners{{30, 0, 0}, {x, -20, 0}, {x, 20, 0}};
    const Mesh mesh(corners, std::vector<TriangleIndices>{{0, 1, 2}});
    const ShapeDistance found = distance({Sphere{{0, 0, 0}, 10}}, {mesh});
    EXPECT_EQ(found.distance == 0, intersects({Sphere{{0, 0, 0}, 10}}, {mesh}));
    return found.distance;
  };
  EXPECT_EQ(gap_at(9.9), 0);
  EXPECT_EQ(gap_at(10), 0);
  EXPECT_NEAR(gap_at(10.1), 0.1, 1e-14);
  const Mesh through(std::vector<Vector3d>{{20, 0, 0}, {-20, 0, 0}, {0, 20, 0}},
                     std::vector<TriangleIndices>{{0, 1, 2}});
  EXPECT_EQ(distance({Sphere{{0, 0, 0}, 10}}, {through}).distance, 0);
}

// Equal cubes that are stacked along one of their own axes, apart or not by what rounding is.
TEST(KnownConfigurations, StackedCubesThatKiss) {
  Eigen::Matrix3d turn;
  turn << 0.94096063217417758029, 0.29296840037289501035, 0.16959541586174811667,
      -0.23569836841299879326, 0.92661523595848427348, -0.29296840037289506586,
      -0.2429801799032638987, 0.23569836841299884878, 0.94096063217417758029;
  for (const double edge : {0.01, 0.25, 0.5, 10.0, 1000.0}) {
    for (const double gap : {-1e-15, -2.5e-16, -1e-16, 0.0, 1e-16, 2.5e-16, 1e-15}) {
      Pose a = Pose::Identity();
      a.linear() = turn;
      a.translation() = Vector3d(0, 0, 5 * edge);
      Pose b = a;
      b.translation() += turn * Vector3d(0, edge + gap * std::max(1.0, edge), 0);
      const Shape cube = Box{{edge / 2, edge / 2, edge / 2}};
      PairLawCounts counts;
      EXPECT_EQ(broken_law({cube, cube, a, b}, {}, counts), "") << edge << " " << gap;
      const Manifold contacts = find_contacts({cube, a}, {cube, b});
      EXPECT_LT(contacts.empty() ? 0 : contacts[0].depth, 1e-14 * (1 + edge)) << edge << " " << gap;
      EXPECT_LT(distance({cube, a}, {cube, b}).distance, 1e-14 * (1 + edge)) << edge << " " << gap;
    }
  }
}

TEST(KnownConfigurations, BoxesAlongTheAxesAsARobotMetThem) {
  expect_known({Box{{0.307, 1.5, 0.185}},
                Box{{0.247, 0.276, 0.005}},
                {-0.692 + 0.675, 0, 0.935 - 0.9115},
                -(0.185 + 0.005 - (0.935 - 0.9115))});
  const double z = 0.8 - 0.53422044196125151316;
  expect_known({Box{{0.1, 0.165, 0.05}},
                Box{{0.226, 0.135, 0.3}},
                {0.192, -0.78769605692727695523 + 0.772, -z},
                -(0.05 + 0.3 - z)});
}

TEST(KnownConfigurations, ABallAndACylinderAsARobotMetThem) {
  const double x = 0.6 - 0.5419794018, y = 0.0621175025;
  expect_known({Cylinder{0.03, 0.325},
                Sphere{{0, 0, 0}, 0.055},
                {-x, -y, 0.6016236576 - 0.325},
                std::hypot(x, y) - (0.03 + 0.055)});
}

// The cylinder's axis leans by 6.3e-6 from y. Its rim reaches past the box's face by 3e-7, and yet
// the two are apart: across the axis, where the box's edge is 1.5e-8 from the side.
TEST(KnownConfigurations, ACylinderBesideAnEdgeAsARobotMetThem) {
  std::istringstream text(
      "cylinder 0.05 0.03\n"
      "at -0.99999999997999022838 6.2572835802045040178e-10 6.3260669852976095481e-06 "
      "0.57500009756757608503 6.3260669851683709551e-06 -6.3943303429958554955e-10 "
      "0.99999999997999056145 -0.42711963046787942977 6.2573180158128459924e-10 1 "
      "6.3942912945996747041e-10 1.1867093358746836351\n"
      "box 0.0125 0.175 0.9225\n"
      "at 0 -1 0 0.8 1 0 0 -0.4575 0 0 1 1.0225\n");
  const PlacedPair pair = *tests::read_pair(text);
  const Vector3d axis = pair.pose_a.linear().col(2);
  const Vector3d across = (Vector3d::UnitX() - axis * axis.x()).normalized();
  const double gap = -width_along(pair, across);
  ASSERT_NEAR(gap, 1.55e-8, 1e-9);
  const ShapeDistance found = distance({pair.a, pair.pose_a}, {pair.b, pair.pose_b});
  EXPECT_NEAR(found.distance, gap, 1e-14);
  EXPECT_FALSE(intersects({pair.a, pair.pose_a}, {pair.b, pair.pose_b}));
}

// In no position in particular: every promise, from both sides.
TEST(KnownConfigurations, OthersThatARobotMet) {
  std::istringstream text(
      "cylinder 0.05 0.03\n"
      "at -0.97313010759279283679 -0.12202804064972551379 0.19526123781136842106 "
      "0.87472781461138560122 0.20950801135757171623 -0.11745920593569325607 "
      "0.97072639199619581429 -0.4038687881347159947 -0.095520609678929752073 "
      "0.98555187191549953329 0.13986894183635001365 1.5871328698116491385\n"
      "box 0.0125 0.175 0.9225\n"
      "at 0 -1 0 0.8 1 0 0 -0.4575 0 0 1 1.0225\n"
      "box 0.015 0.06 0.05\n"
      "at -3.0627937852578681533e-08 -0.99999999999999888978 -2.8893865161583314238e-08 "
      "0.63499979627350811029 0.9999999999999980016 -3.0627939739957803544e-08 "
      "6.4729926918527511769e-08 -0.48500002215636439651 -6.4729927722963847085e-08 "
      "-2.8893863029448751323e-08 0.99999999999999711342 1.0778146458339641356\n"
      "box 0.0125 0.175 0.9225\n"
      "at 0 -1 0 0.8 1 0 0 -0.4575 0 0 1 1.0225\n"
      "box 0.245 0.025 0.105\n"
      "at 4.8966386501092529215e-12 -1 0 -0.44 1 4.8966386501092529215e-12 0 "
      "-0.61499999999858001587 0 0 1 0.355\n"
      "box 0.0175 0.06 0.015\n"
      "at 0.83512153565236335595 -0.55006546945762568868 -9.4542360608233572896e-16 "
      "-0.40653441507331000704 0.55006546945762568868 0.83512153565236313391 "
      "1.1787444236552387666e-15 -0.69166166923735727945 1.2902271444330665572e-16 "
      "-1.4878153530113264589e-15 1 0.43057093858718892276\n"
      "box 0.15825 0.1138 0.0884\n"
      "at 0.44540578475530234748 0.89532881496493399442 -8.8937407685638678971e-09 "
      "1.2652949075960071568 -0.89532881496493377238 0.44540578475530190339 "
      "-2.8948680226084145336e-08 1.4551012423210101243 -2.1957263975186326105e-08 "
      "2.0856732016652919226e-08 0.99999999999999955591 0.49480006232932938204\n"
      "box 0.24715 0.1773 0.0376\n"
      "at 0.44171122913485860728 0.8971572827861190591 -1.622764514865468214e-09 "
      "1.1304016226141906376 -0.8971572827861190591 0.44171122913485860728 "
      "-5.1621053952306079594e-09 1.8410802645284281009 -3.9144271413829990148e-09 "
      "3.7360349218094348098e-09 1 0.44400006232932492933\n"
      "box 0.025 0.275 0.15\n"
      "at 0.00079632671073326442932 -0.99999968293183538748 0 0.75000000000000055511 "
      "0.99999968293183538748 0.00079632671073326442932 0 -2.4083553715553102684e-15 0 0 1 0.15\n"
      "box 0.125 0.1 0.075\n"
      "at 6.1232339957367660359e-17 0 1 0.75 -1 6.1232339957367660359e-17 "
      "6.1232339957367660359e-17 "
      "0 -6.1232339957367660359e-17 -1 3.7493994566546440196e-33 0.15\n"
      "sphere 0 0 0 0.06\n"
      "at -0.99999999999999955591 -4.4637642593504144998e-09 0 1.7855056639081962376e-10 "
      "4.4637642593504144998e-09 -0.99999999999999955591 0 0.039999999999999993894 0 0 "
      "1.0000000000000008882 0.33000000000000012657\n"
      "box 0.05 0.05 0.05\n"
      "at 1 0 0 0.05 0 1 0 0.15 0 0 1 0.35\n"
      "convex hull 0.5 0.5 -0.866025 0.5 -0.5 -0.866025 0.5 1 0 -0.5 -0.5 0.866025 -0.5 0.5 "
      "0.866025 -0.5 -1 0 0.5 -0.5 0.866025 -0.5 0.5 -0.866025 -0.5 -0.5 -0.866025 -0.5 1 0 0.5 -1 "
      "0 0.5 0.5 0.866025\n"
      "at -3.0140487242790098936e-09 0.34009658459984087875 -0.94039051098122172778 "
      "4.2864836941313040342 1.090044683538143324e-09 0.94039051098122172778 "
      "0.34009658459984087875 7.3869576872253679412 1 0 -3.2051032938795742666e-09 0\n"
      "convex hull 4.149402 8.493709 -0.5 5.188451 7.476263 -0.5 3.931647 7.374503 -0.5 4.149402 "
      "8.493709 0.5 3.931647 7.374503 0.5 5.188451 7.476263 0.5\n"
      "at 1 0 0 0 0 1 0 0 0 0 1 0\n");
  PairLawCounts counts;
  while (const std::optional<PlacedPair> pair = tests::read_pair(text))
    EXPECT_EQ(broken_law(*pair, {.directions = 2000}, counts), "") << text_of(*pair);
  EXPECT_EQ(counts.pairs, 7u);
  EXPECT_EQ(counts.unconverged, 0u);
  EXPECT_EQ(counts.unproved, 0u);
}

// A box in a pose that law 10 just lets in is read otherwise by its test than by its support: what
// the one says touches has contacts.
TEST(KnownConfigurations, ABoxWhosePoseDeviatesHasContactsWithTheMeshThatItTouches) {
  Pose pose = Pose::Identity();
  pose.linear()(1, 1) = 1 - 0x1p-30;
  pose.translation() = Eigen::Vector3d(0.25, 2, 0.25);
  const Mesh mesh = tests::make_box({1, 1, 1});
  const Shape box = Box{{1, 1, 1}};
  ASSERT_TRUE(intersects({mesh}, {box, pose}));
  EXPECT_FALSE(find_contacts({mesh}, {box, pose}).empty());
  EXPECT_FALSE(find_contacts({box, pose}, {mesh}).empty());
}

}  // namespace
}  // namespace graze
