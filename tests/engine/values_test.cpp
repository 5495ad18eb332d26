// What public values have beside their numbers: hashes, comparison, text, matrices, versions.

#include <graze/forward.h>
#include <graze/graze.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

template <typename T>
std::string text_of(const T& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

TEST(Values, IdsAndPairsAreKeysOfTables) {
  std::unordered_set<BodyId> bodies;
  std::unordered_set<BoxPair> boxes;
  std::unordered_map<BodyPair, int> touching;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    bodies.insert({i % 100, i / 100});
    boxes.insert({i % 100, i});
    touching[{{i, 0}, {i + 1, 0}}] += 1;
  }
  EXPECT_EQ(bodies.size(), 1000u);
  EXPECT_EQ(boxes.size(), 1000u);
  EXPECT_EQ(touching.size(), 1000u);
  EXPECT_EQ(touching.at({{7, 0}, {8, 0}}), 1);
  std::unordered_set<WorldBodyPair> of_two_worlds;
  for (std::uint32_t i = 0; i < 1000; ++i)
    of_two_worlds.insert(WorldBodyPair{{i % 10, i / 100}, {i / 10 % 10, 0}});
  EXPECT_EQ(of_two_worlds.size(), 1000u);
  std::unordered_set<std::size_t> low_bits;
  for (std::uint32_t i = 0; i < 256; ++i)
    low_bits.insert(std::hash<TrianglePair>()({i, 0}) % 256);
  EXPECT_GT(low_bits.size(), 128u) << "indices in a row spread over a table";
}

TEST(Values, PosesAreKeysToo) {
  std::unordered_map<Pose, int, PoseHash, PoseEqual> seen;
  for (int i = 0; i < 100; ++i)
    seen[tests::at(i % 10)] = i;
  EXPECT_EQ(seen.size(), 10u);
  Pose negative = tests::at(1);
  negative.translation().y() = -0.0;
  EXPECT_TRUE(are_equal(negative, tests::at(1)));
  EXPECT_EQ(PoseHash()(negative), PoseHash()(tests::at(1)));
  EXPECT_FALSE(are_equal(tests::at(1), tests::at(2)));
}

TEST(Values, ResultsAreEqualWhereAllTheirNumbersAre) {
  const Mesh ball = tests::make_sphere(1, 8, 12);
  const Pose near = tests::at(1.5), other = tests::at(1.5 + 1e-9);
  EXPECT_EQ(distance({ball}, {ball, tests::at(3)}), distance({ball}, {ball, tests::at(3)}));
  EXPECT_NE(distance({ball}, {ball, tests::at(3)}), distance({ball}, {ball, tests::at(4)}));
  EXPECT_EQ(find_triangle_pairs({ball}, {ball, near}), find_triangle_pairs({ball}, {ball, near}));
  EXPECT_NE(find_contacts({ball}, {ball, near}), find_contacts({ball}, {ball, other}));
  EXPECT_EQ(separating_translation({ball}, {ball, near}),
            separating_translation({ball}, {ball, near}));
  const Shape box = Box{{1, 1, 1}};
  const Manifold manifold = find_contacts({box}, {box, tests::at(1.9)});
  Manifold same = manifold;
  ASSERT_LE(same.size(), 4u);
  EXPECT_EQ(manifold, same);
  same[0].depth *= 2;
  EXPECT_NE(manifold, same);
  EXPECT_EQ(Manifold(), Manifold()) << "of no contact no number counts";
  EXPECT_NE(manifold, Manifold());
}

TEST(Values, ShapesAndMotionsAreEqualWhereAllTheirNumbersAre) {
  const Mesh mesh = tests::make_box({1, 1, 1});
  const ConvexHull hull(mesh.vertices());
  const std::vector<Shape> shapes{Sphere{{0, 0, 0}, 1},
                                  Box{{1, 2, 3}},
                                  Capsule{1, 2},
                                  Cylinder{1, 2},
                                  Cone{1, 2},
                                  Ellipsoid{{0, 0, 0}, {1, 2, 3}},
                                  hull,
                                  HalfSpace{{0, 0, 1}, 2},
                                  mesh,
                                  Plane{{0, 0, 1}, 2},
                                  Box{{1, 2, 4}},
                                  Cylinder{2, 2}};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t j = 0; j < shapes.size(); ++j)
      EXPECT_EQ(shapes[i] == shapes[j], i == j);
    const PlacedShape placed{shapes[i], tests::at(1)};
    EXPECT_EQ(placed, (PlacedShape{shapes[i], tests::at(1)}));
    EXPECT_FALSE(placed == (PlacedShape{shapes[i], tests::at(2)}));
  }
  EXPECT_FALSE(Shape(hull) == Shape(ConvexHull(mesh.vertices()))) << "another handle";
  EXPECT_EQ((PlacedMesh{mesh, tests::at(1)}), (PlacedMesh{mesh, tests::at(1)}));
  EXPECT_FALSE((PlacedMesh{mesh}) == (PlacedMesh{tests::make_box({1, 1, 1})}));
  EXPECT_EQ((RigidCourse{.angle = 1}), (RigidCourse{.angle = 1}));
  EXPECT_FALSE((RigidCourse{.angle = 1}) == (RigidCourse{.angle = 2}));
  EXPECT_FALSE((RigidVelocities{.duration = 1}) == (RigidVelocities{.duration = 2}));
  EXPECT_FALSE((Screw{.pitch = 1}) == (Screw{.pitch = 2}));
}

TEST(Values, ShapesAndMotionsAsText) {
  EXPECT_EQ(text_of(Box{{1, 2, 3}}), "box of half extents (1, 2, 3)");
  EXPECT_EQ(text_of(Capsule{1, 2}), "capsule of radius 1 and half length 2");
  EXPECT_EQ(text_of(Cylinder{1, 2}), "cylinder of radius 1 and half height 2");
  EXPECT_EQ(text_of(Cone{1, 2}), "cone of radius 1 and half height 2");
  EXPECT_EQ(text_of(Ellipsoid{{0, 0, 0}, {1, 2, 3}}),
            "ellipsoid around (0, 0, 0) of semi-axes (1, 2, 3)");
  EXPECT_EQ(text_of(HalfSpace{{0, 0, 1}, 2}), "half-space below 2 along (0, 0, 1)");
  EXPECT_EQ(text_of(Plane{{0, 0, 1}, 2}), "plane at 2 along (0, 0, 1)");
  const Mesh mesh = tests::make_box({1, 1, 1});
  EXPECT_EQ(text_of(mesh), "mesh of 8 vertices and 12 triangles");
  EXPECT_EQ(text_of(ConvexHull(mesh.vertices())), "hull of 8 vertices");
  EXPECT_EQ(text_of(HeightField(3, 2, std::vector<float>(6, 0.f))),
            "height field of 3 x 2 heights");
  EXPECT_EQ(text_of(FieldRange{1, 2, 3, 4}), "3 x 4 heights from column 1, row 2");
  EXPECT_EQ(text_of(Shape(Sphere{{1, 2, 3}, 0.5})), "ball around (1, 2, 3) of radius 0.5");
  const std::string pose = " in pose 1 0 0 1 0 1 0 0 0 0 1 0";
  EXPECT_EQ(text_of(PlacedShape{Capsule{1, 2}, tests::at(1)}), text_of(Capsule{1, 2}) + pose);
  EXPECT_EQ(text_of(PlacedMesh{mesh, tests::at(1)}), text_of(mesh) + pose);
  const RigidMotion slide(tests::at(1), {.shift = {0, 0, 2}});
  EXPECT_EQ(text_of(ShapeInMotion{Capsule{1, 2}, slide}),
            text_of(Capsule{1, 2}) + " " + text_of(slide));
  const MeshInMotion moving{mesh, slide};
  EXPECT_EQ(text_of(moving), text_of(mesh) + " " + text_of(slide));
  EXPECT_EQ(text_of(RigidPair{moving, moving}), text_of(moving) + " and " + text_of(moving));
  EXPECT_EQ(text_of(RigidCourse{.shift = {1, 0, 0}, .angle = 2}),
            "by (1, 0, 0) and 2 rad about (0, 0, 1) through (0, 0, 0)");
  EXPECT_EQ(text_of(RigidVelocities{.linear = {1, 0, 0}, .duration = 3}),
            "for 3 s by (1, 0, 0) m/s and (0, 0, 0) rad/s around (0, 0, 0)");
  EXPECT_EQ(text_of(Screw{.angle = 1, .pitch = 2}),
            "by 1 rad about (0, 0, 1) through (0, 0, 0), 2 a turn");
  EXPECT_EQ(text_of(PointPath{{0, 0, 0}, {1, 0, 0}}), "from (0, 0, 0) to (1, 0, 0)");
  EXPECT_EQ(text_of(MeshSides::one_sided(0.5)), "one-sided, 0.5 thick");
  EXPECT_EQ(text_of(MeshSides::solid()), "solid");
  EXPECT_EQ(text_of(Filter{1, 6, -2}), "categories 1, mask 6, group -2");
  EXPECT_EQ(text_of(BoxGap{0.5, 1, true}), "gap 0.5 in y, A below");
  EXPECT_EQ(text_of(BoxGap{0, 0, false}), "no gap");
  EXPECT_EQ(text_of(ErrorPlace{}), "nowhere known");
  EXPECT_EQ(text_of(ErrorPlace{.line = 3}), "line 3");
  EXPECT_EQ(text_of(ErrorPlace{.file = "a.obj", .line = 3}), "a.obj:3");
  EXPECT_EQ(text_of(ErrorPlace{.element = "pose", .index = 2}), "pose 2");
}

TEST(Values, PartsOfResultsAsText) {
  EXPECT_EQ(text_of(FaultyEdge{{1, 2}, 3, 4}), "edge 1-2 of 4 triangles from 3");
  EXPECT_EQ(text_of(DuplicateTriangle{5, 2}), "triangle 5 as 2");
  EXPECT_EQ(text_of(InsideOutPart{1, 2, 3}), "part of 2 triangles from 1, inside 3");
  EXPECT_EQ(text_of(IntersectionPoint{{0, 0, 1}, Feature::Edge, Feature::Face}),
            "point (0, 0, 1) in edge and face");
  EXPECT_EQ(text_of(IntersectionSegment{1, 2, 3, 4}), "segment 1-2 of 4 pairs from 3");
  EXPECT_EQ(text_of(IntersectionCurve{1, 2, true}), "closed curve of 2 segments from 1");
  EXPECT_EQ(text_of(IntersectionPolygon{{1, 2, 3}, 3, 4, 5}), "polygon 1-2-3 of 5 pairs from 4");
  EXPECT_EQ(text_of(IntersectionPatch{1, 2}), "patch of 2 polygons from 1");
  EXPECT_EQ(text_of(TouchingPoint{1, 2, 3}), "touching point 1 of 3 pairs from 2");
  EXPECT_EQ(text_of(FreedomStep{FreedomStep::Kind::Plane, 0, {0, 0, 1}}), "plane across (0, 0, 1)");
  EXPECT_EQ(text_of(FreedomStep{FreedomStep::Kind::DivideB, 7, {0, 0, 0}}),
            "divide B after 7 triangles");
  EXPECT_EQ(text_of(BroadPhaseWork{}), "no work");
  EXPECT_EQ(text_of(BroadPhaseWork{.updates = 2}), "2 updates");
}

TEST(Values, EnumeratorsAsText) {
  EXPECT_EQ(text_of(Hit::Crossing), "crossing");
  EXPECT_EQ(text_of(RigidStatus::Close), "close");
  EXPECT_EQ(text_of(Sides::OneSided), "one-sided");
  EXPECT_EQ(text_of(BodyKind::Kinematic), "kinematic");
  EXPECT_EQ(text_of(PairMethod::Meshes), "meshes");
  EXPECT_EQ(text_of(PairStatus::NotConverged), "not converged");
  EXPECT_EQ(text_of(MeetingFeatures::AtStart), "at the start");
  EXPECT_EQ(text_of(PairVolume::WideObb), "wide");
  EXPECT_EQ(text_of(ShapeKind::ConvexHull), name_of(ShapeKind::ConvexHull));
  EXPECT_EQ(text_of(static_cast<Role>(7)), "no enumerator: 7");
  EXPECT_EQ(text_of(static_cast<Volume>(9)), "no enumerator: 9");
  EXPECT_EQ(text_of(static_cast<PairVolume>(9)), "no enumerator: 9");
  EXPECT_EQ(text_of(static_cast<ShapeKind>(90)), "no enumerator: 90");
}

TEST(Values, TextIsTheSameWhateverTheStreamHasSet) {
  EXPECT_EQ(text_of(BodyId{3, 1}), "body 3.1");
  EXPECT_EQ(text_of(BodyPair{{3, 1}, {4, 0}}), "body 3.1 and body 4.0");
  EXPECT_EQ(text_of(TrianglePair{12, 7}), "12-7");
  EXPECT_EQ(text_of(Aabb{{0, 0.1, 0}, {1, 2, 3}}), "box from (0, 0.1, 0) to (1, 2, 3)");
  EXPECT_EQ(text_of(Sphere{{1, 2, 3}, 0.5}), "ball around (1, 2, 3) of radius 0.5");
  TrianglePairs pairs;
  EXPECT_EQ(text_of(pairs), "0 pairs");
  for (std::uint32_t i = 0; i < 18; ++i)
    pairs.pairs.push_back({i, i});
  pairs.completeness = Completeness::LimitReached;
  EXPECT_EQ(text_of(pairs),
            "18 pairs: 0-0 1-1 2-2 3-3 4-4 5-5 6-6 7-7 8-8 9-9 10-10 11-11 12-12 13-13 14-14 15-15 "
            "and 2 more (limit reached)");
  std::ostringstream strange;
  strange << std::hex << std::showpos;
  strange.precision(2);
  strange << TrianglePair{12, 7} << " " << Sphere{{1, 2, 3}, 0.123456789};
  EXPECT_EQ(strange.str(), "12-7 ball around (1, 2, 3) of radius 0.123456789");
  EXPECT_EQ(text_of(Work{}), "no work");
  Work work;
  work.volume_tests = 12, work.exact_tests = 1;
  EXPECT_EQ(text_of(work), "12 volume tests, 1 exact tests");
  WorldWork of_world;
  EXPECT_EQ(text_of(of_world), "no work");
  of_world.pairs_apart = 3;
  EXPECT_EQ(text_of(of_world), "3 pairs apart");
  of_world.shapes = work;
  EXPECT_EQ(text_of(of_world), "3 pairs apart, 12 volume tests, 1 exact tests");
}

TEST(Values, TextOfWhatTwoShareIsOneLine) {
  const Mesh box = tests::make_box({1, 1, 1});
  EXPECT_EQ(text_of(box.topology()),
            "closed, 8 vertices, 1 components, 0 boundary edges, 0 degenerate and 0 duplicate "
            "triangles");
  EXPECT_EQ(text_of(MeshIntersection{}),
            "0 curves, 0 patches, 0 touching points: 0 points, 0 segments and 0 polygons of 0 "
            "pairs");
  const Voxels voxels = find_voxels(box, {.resolution = 2});
  EXPECT_EQ(text_of(voxels), "8 voxels of a grid of 2 x 2 x 2 voxels of 1 from (-1, -1, -1)");
  const Triangle s{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(text_of(intersection(s, {{5, 5, 5}, {6, 5, 5}, {5, 6, 5}})), "nothing");
  EXPECT_EQ(text_of(intersection(s, {{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}})), "point (0, 0, 0)");
  const ShapeSeparation apart{2, {1, 0, 0}, {3, 0, 0}, {1, 0, 0}, PairStatus::Converged};
  EXPECT_EQ(text_of(apart), "separation 2 from (1, 0, 0) to (3, 0, 0), normal (1, 0, 0)");
  const MeshFit fit = measure_fit(box);
  EXPECT_EQ(text_of(fit.volumes[0]), "aabb of 8 m^3 and 24 m^2, empty share 0");
  EXPECT_EQ(text_of(fit).substr(0, 31), "encloses 8 m^3; aabb of 8 m^3 a");
}

TEST(Values, TextOfMotionsAndWorldsIsOneLine) {
  const Mesh box = tests::make_box({1, 1, 1});
  const RigidMotion rest(Pose::Identity()), passing(tests::at(4), {.shift = {1, 0, 0}});
  EXPECT_EQ(text_of(passing),
            "from pose 1 0 0 4 0 1 0 0 0 0 1 0 by (1, 0, 0) and 0 rad about (0, 0, 1) through "
            "(0, 0, 0)");
  const auto proof = certify_free({box, rest}, {box, passing});
  ASSERT_TRUE(proof);
  EXPECT_EQ(text_of(*proof), "proof of 1 steps that 12 and 12 triangles stay further apart than 0");
  EXPECT_EQ(text_of(WorldUpdate{}),
            "0 begun, 0 ended, 0 moved, 0 contacts, 0 begun near, 0 ended near, 0 first contacts");
  EXPECT_EQ(text_of(WorldBodyPair{{3, 1}, {4, 0}}), "body 3.1 and body 4.0");
  const ShapeDistance gap{.distance = 1,
                          .lower_bound = 1,
                          .point_a = {0, 0, 0},
                          .point_b = {1, 0, 0},
                          .normal = {1, 0, 0},
                          .status = PairStatus::Converged};
  EXPECT_EQ(text_of(BodyPairDistance{{3, 1}, {4, 0}, gap, 0, 2}),
            "body 3.1 and body 4.0: parts 0 and 2, distance 1 from (0, 0, 0) to (1, 0, 0), normal "
            "(1, 0, 0), at least 1");
  BodyFirstContact contact{};
  contact.pair = {{3, 1}, {4, 0}};
  contact.contact.status = RigidStatus::Hit;
  contact.contact.low = 0.25, contact.contact.high = 0.5;
  contact.normal = contact.point = Eigen::Vector3d(1, 0, 0);
  EXPECT_EQ(
      text_of(contact),
      "body 3.1 and body 4.0: free up to 0.25, hit at 0.5, point (1, 0, 0), normal (1, 0, 0)");
}

TEST(Values, TextOfAPoseIsReadBackToTheLastBit) {
  RandomSource source(5);
  for (int i = 0; i < 100; ++i) {
    const Pose pose = tests::random_pose(10, source);
    EXPECT_TRUE(are_equal(parse_pose(to_text(pose), "here"), pose));
  }
}

TEST(Values, MeshesAreMadeOfMatricesAndGiveThemBack) {
  const Mesh mesh = tests::make_torus(1, 0.4, 8, 6);
  const Eigen::MatrixXd vertices = mesh.vertex_matrix();
  const Eigen::MatrixXi triangles = mesh.triangle_matrix().cast<int>();
  ASSERT_EQ(vertices.rows(), static_cast<Eigen::Index>(mesh.vertices().size()));
  EXPECT_EQ(vertices(5, 2), mesh.vertices()[5].z());
  const auto expect_same = [&](const Mesh& other) {
    EXPECT_EQ(other.vertex_matrix(), mesh.vertex_matrix());
    EXPECT_EQ(other.triangle_matrix(), mesh.triangle_matrix());
  };
  expect_same(Mesh(vertices, triangles));
  const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> by_rows = vertices;
  const Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor> triangles_by_rows = triangles;
  expect_same(Mesh(by_rows, triangles_by_rows));
  Eigen::MatrixXd wide = Eigen::MatrixXd::Zero(vertices.rows(), 7);
  wide.middleCols(2, 3) = vertices;
  expect_same(Mesh(wide.middleCols(2, 3), triangles));
  expect_same(mesh.deformed(Eigen::MatrixXd(2 * vertices)).deformed(vertices));
  EXPECT_THROW(Mesh(wide, triangles), MeshError);
  EXPECT_THROW(Mesh(vertices, Eigen::MatrixXi(triangles.leftCols(2))), MeshError);
}

TEST(Values, APlacedMeshKeepsItsMesh) {
  const auto make = [] { return PlacedMesh{tests::make_box({1, 1, 1}), tests::at(1.5)}; };
  const PlacedMesh kept = make();
  EXPECT_TRUE(intersects(kept, PlacedMesh{tests::make_box({1, 1, 1})}));
  EXPECT_TRUE(intersects({kept.mesh}, kept));
}

TEST(Values, AMeshGoesBesideAnyShape) {
  const Mesh box = tests::make_box({1, 1, 1});
  EXPECT_TRUE(intersects({box}, {Capsule{0.5, 1}, tests::at(1.4)}));
  EXPECT_FALSE(intersects({Capsule{0.5, 1}, tests::at(1.6)}, {box}));
  EXPECT_NEAR(distance({box}, {Sphere{{0, 0, 0}, 0.5}, tests::at(2)}).distance, 0.5, 1e-9);
  static_assert(std::is_same_v<decltype(find_contacts({box}, {box})), MeshContacts>);
  static_assert(std::is_same_v<decltype(find_contacts({Shape(box)}, {box})), Manifold>);
}

TEST(Values, TheVersionIsThatOfTheHeaders) {
  EXPECT_EQ(library_version(), std::to_string(kVersionMajor) + "." + std::to_string(kVersionMinor) +
                                   "." + std::to_string(kVersionPatch));
}

}  // namespace
}  // namespace graze
