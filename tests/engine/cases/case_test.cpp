// Queries as files: nothing is lost on the way, and they can be asked again.

#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/case_mesh_file.h>
#include <graze/engine/cases/motion_case.h>
#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/text/case_words.h>
#include <graze/engine/cases/text/hex_float.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/files/sha256.h>
#include <graze/engine/mesh/containment.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shape_ray.h>
#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <graze/narrowphase/volumes/contains.h>
#include <graze/narrowphase/volumes/obb_overlap.h>
#include <graze/narrowphase/volumes/sphere_box.h>
#include <graze/narrowphase/volumes/sphere_overlap.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

#include "tests/files/temporary_directory.h"
#include "tests/narrowphase/simd_targets.h"
#include "tests/shapes/formula_meshes.h"

namespace graze {
namespace {

/// Two rough bodies into each other, and what can be asked of them.
class Cases : public testing::Test {
 protected:
  Cases() {
    pose_.linear() =
        Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    pose_.translation() << 1.25, 0.1, 0.3;
    far_ = pose_;
    far_.translation().x() = 3;
  }

  PlacedMesh a() const { return {torus_}; }
  PlacedMesh b(const Pose& pose) const { return {sphere_, pose}; }

  std::vector<Case> all_queries() const {
    const Obb obb{pose_, {0.5, 0.25, 0.125}};
    const Aabb box{{0.5, 0, -1}, {1, 1, 1}};
    const Sphere ball{{1, 0.1, 0}, 0.2};
    const Triangle s{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Triangle t{{0.1, 0.1, -1}, {0.1, 0.1, 1}, {5, 5, 5}};
    const SeparatingTranslation apart = separating_translation(a(), b(pose_));
    return {
        to_case(a(), b(pose_), intersects(a(), b(pose_))),
        to_case(a(), b(far_), intersects(a(), b(far_), {.hit = Hit::Solid}), {.hit = Hit::Solid}),
        to_case(a(), b(pose_), intersects(a(), b(pose_), {.hit = Hit::Crossing}),
                {.hit = Hit::Crossing}),
        to_case(a(), b(pose_), find_triangle_pairs(a(), b(pose_))),
        to_case(a(), b(far_), distance(a(), b(far_))),
        to_case_within(a(), b(far_), 0.125, within(a(), b(far_), 0.125)),
        to_case(a(), b(pose_), find_contacts(a(), b(pose_))),
        to_case(a(), b(pose_), apart),
        to_case(CaseMesh(a()), box, intersects(a(), box)),
        to_case(CaseMesh(a()), obb, intersects(a(), obb)),
        to_case(CaseMesh(a()), ball, intersects(a(), ball)),
        to_case(b(pose_), box, find_triangles(b(pose_), box)),
        to_case(b(pose_), obb, find_triangles(b(pose_), obb)),
        to_case(b(pose_), ball, find_triangles(b(pose_), ball)),
        to_case(s, t, intersects(s, t)),
        to_case(s, box, intersects(s, box)),
        to_case(s, obb, intersects(s, obb)),
        to_case(s, ball, intersects(s, ball)),
        to_case(box, obb, intersects(box, obb)),
        to_case(ball, ball, intersects(ball, ball)),
        to_case(ball, obb, intersects(ball, obb)),
        to_case_contains(sphere_, Eigen::Vector3d(0, 0, 0.5), contains(sphere_, {0, 0, 0.5})),
        to_case_self(torus_, self_intersects(torus_)),
        to_case_self(torus_, find_self_pairs(torus_)),
        to_case({torus_}, {torus_, pose_}, find_triangle_pairs({torus_}, {torus_, pose_}))};
  }

  /// Those whose answers have parts of their own.
  std::vector<Case> queries_with_parts() const {
    const Triangle s{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Triangle t{{0.1, 0.1, -1}, {0.1, 0.1, 1}, {5, 5, 5}};
    const Triangle above{{0, 0, 1}, {1, 0, 1.5}, {0, 1, 1}};
    const Eigen::Vector3d up(0, 0.5, 2);
    const PairSettings two{.limit = 2};
    const TriangleSettings three{.limit = 3};
    const SelfSettings neighbours{.kind = SelfPairKind::Neighbour};
    const SelfSettings few{.kind = SelfPairKind::Neighbour, .limit = 5};
    const Aabb box{{0.5, 0, -1}, {1, 1, 1}};
    const Ray along{{-2, 0.1, 0.05}, {3, 0.01, 0}};
    const Ray away{{-2, 0, 0}, {-1, 0, 0}};
    const Ray short_one{.origin = {-2, 0, 0.5}, .direction = {1, 0, 0}, .max_distance = 0.25};
    const CaseBody hull(Capsule{0.3, 0.5}, pose_);
    const CaseBody ring(torus_, Pose::Identity());
    const CaseBody far_hull(Cone{0.3, 0.5}, far_);
    const auto gap = distance({hull.shape, hull.pose}, {far_hull.shape, far_hull.pose});
    const auto manifold = find_contacts({hull.shape, hull.pose}, {ring.shape, ring.pose});
    return {to_case(a(), b(pose_), find_intersection(a(), b(pose_))),
            to_case({box_}, {box_, on_top_}, find_intersection({box_}, {box_, on_top_})),
            to_case({box_}, {box_, corner_to_corner_},
                    find_intersection({box_}, {box_, corner_to_corner_})),
            to_case(a(), b(far_), find_intersection(a(), b(far_))),
            to_case(a(), b(pose_), separating_translation(a(), b(pose_), up), up),
            to_case(a(), b(pose_), find_triangle_pairs(a(), b(pose_), two), two),
            to_case(b(pose_), box, find_triangles(b(pose_), box, three), three),
            to_case_self(torus_, find_self_pairs(torus_, neighbours), neighbours),
            to_case_self(torus_, find_self_pairs(torus_, few), few),
            to_case(s, above, distance(s, above)),
            to_case(s, t, intersection(s, t)),
            to_case(s, s, intersection(s, s)),
            to_case(s, above, intersection(s, above)),
            to_case(s, t, Touch::Exclude, intersects(s, t, Touch::Exclude)),
            to_case(hull, far_hull, gap),
            to_case(hull, ring, manifold),
            to_case(CaseShape(CaseMesh(a())), along, cast_ray(a(), along)),
            to_case(CaseShape(CaseMesh(a())), away, cast_ray(a(), away)),
            to_case(CaseShape(CaseMesh(a())), short_one, cast_ray(a(), short_one)),
            to_case(a(), along, cast_ray_all(a(), along)),
            to_case(s, Ray{{0.1, 0.1, 5}, {0, 0, -2}}, cast_ray(s, Ray{{0.1, 0.1, 5}, {0, 0, -2}})),
            to_case(CaseShape(hull), along, cast_ray({hull.shape, hull.pose}, along)),
            to_case(CaseShape(ring), along, cast_ray({ring.shape, ring.pose}, along)),
            to_case_contains(CaseShape(box), {0.75, 0.5, 0}, contains(box, {0.75, 0.5, 0})),
            to_case_contains(CaseShape(Obb{pose_, {1, 1, 1}}), {9, 0, 0}, false),
            to_case_contains(CaseShape(Sphere{{1, 0, 0}, 1}), {2, 0, 0}, true)};
  }

  /// A ball that comes from the side and turns, and a ring that rests.
  std::vector<Case> queries_of_motions() const {
    const RigidMotion rests{Pose::Identity()};
    const RigidMotion comes(
        far_, {.centre = {3, 0, 0}, .shift = {-4, 0.25, 0}, .axis = {1, 2, 3}, .angle = 2});
    const RigidMotion passes(far_, {.shift = {0, 4, 0}});
    std::vector<Case> queries;
    for (const RigidMotion& motion : {comes, passes}) {
      const CaseMesh ring = case_mesh(torus_, rests), ball = case_mesh(sphere_, motion);
      const RigidContactSettings wide{.clearance = 0.125, .tolerance = 0.01};
      queries.push_back(to_case(ring, ball, first_contact({torus_, rests}, {sphere_, motion})));
      queries.push_back(
          to_case(ring, ball, first_contact({torus_, rests}, {sphere_, motion}, wide), wide));
      queries.push_back(
          to_case_free(ball, ring, is_free({sphere_, motion}, {torus_, rests}, wide), wide));
      const Shape cone(Cone{0.3, 0.5}), whole(torus_);
      const CaseBody a = case_body(whole, rests), b = case_body(cone, motion);
      queries.push_back(to_case(a, b, first_contact({whole, rests}, {cone, motion})));
      queries.push_back(to_case_free(b, a, is_free({cone, motion}, {whole, rests})));
    }
    return queries;
  }

  Mesh torus_ = tests::make_torus(1, 0.3, 20, 12);
  Mesh sphere_ = tests::make_sphere(0.75, 9, 13);
  Pose pose_ = Pose::Identity();
  Mesh box_ = tests::make_box({1, 1, 1});
  Pose far_ = Pose::Identity();
  Pose on_top_ = Pose(Eigen::Translation3d(0.25, 0.5, 2));
  Pose corner_to_corner_ = Pose(Eigen::Translation3d(2, 2, 2));
};

TEST_F(Cases, EveryQueryWritesItselfAndComesBack) {
  std::set<Ask> asked;
  std::vector<Case> queries = all_queries();
  for (const Case& query : queries_with_parts())
    queries.push_back(query);
  for (const Case& query : queries_of_motions())
    queries.push_back(query);
  for (const Case& query : queries) {
    asked.insert(query.ask);
    const std::string text = to_json(query);
    SCOPED_TRACE(text.substr(0, 60));
    const Case back = parse_case(text, "memory");
    EXPECT_EQ(to_json(back), text);
    EXPECT_TRUE(is_same(*back.answer, *query.answer));
    EXPECT_TRUE(is_same(answer_case(back), *query.answer));
    EXPECT_EQ(back.answered_by.engine, "graze");
  }
  EXPECT_EQ(asked.size(), cases::kAsks.size()) << "a question that no query asks";
}

TEST_F(Cases, ReplayBitForBitOnEverySimdTarget) {
  std::vector<Case> queries = all_queries();
  for (const Case& query : queries_with_parts())
    queries.push_back(query);
  for (const Case& query : queries_of_motions())
    queries.push_back(query);
  for (const Case& query : queries) {
    const Case back = parse_case(to_json(query), "memory");
    for (const std::int64_t target : narrowphase::simd_targets()) {
      narrowphase::force_simd_target(target);
      EXPECT_TRUE(is_same(answer_case(back), *query.answer)) << name_of(query.ask) << " " << target;
    }
    narrowphase::force_simd_target(0);
  }
}

/// The cases above hold something in each part: an empty answer comes back whatever is forgotten.
TEST_F(Cases, AnswersHaveAllTheirParts) {
  std::size_t curves = 0;
  std::size_t patches = 0;
  std::size_t touches = 0;
  std::size_t hits = 0;
  std::size_t contacts = 0;
  std::set<std::size_t> corners;
  for (const Case& query : queries_with_parts()) {
    const CaseAnswer& answer = *query.answer;
    if (answer.intersection) {
      curves += answer.intersection->curves.size();
      patches += answer.intersection->patches.size();
      touches += answer.intersection->touching_points.size();
    }
    if (answer.hits) hits = std::max(hits, answer.hits->size());
    if (answer.manifold) contacts += answer.manifold->size();
    if (answer.corners) corners.insert(answer.corners->size());
  }
  EXPECT_GT(curves, 0u);
  EXPECT_GT(patches, 0u);
  EXPECT_GT(touches, 0u);
  EXPECT_GT(hits, 1u);
  EXPECT_GT(contacts, 0u);
  EXPECT_EQ(corners, (std::set<std::size_t>{0, 2, 3}));
}

/// One bit more in any part is another answer.
TEST_F(Cases, AnAnswerWithAnotherBitIsAnother) {
  std::size_t changed = 0;
  const auto expect_other = [&](const CaseAnswer& answer, const auto& change) {
    CaseAnswer other = answer;
    EXPECT_TRUE(is_same(answer, other));
    change(other);
    EXPECT_FALSE(is_same(answer, other)) << to_json(answer).substr(0, 60);
    EXPECT_NE(to_json(answer), to_json(other));
    ++changed;
  };
  const auto next = [](double& value) { value = std::nextafter(value, 1e9); };
  for (const Case& query : queries_with_parts()) {
    const CaseAnswer& answer = *query.answer;
    if (answer.lower_bound) {
      expect_other(answer, [&](CaseAnswer& a) { next(*a.lower_bound); });
      expect_other(answer, [&](CaseAnswer& a) { next(a.normal->x()); });
      expect_other(answer, [&](CaseAnswer& a) { a.is_converged = !*a.is_converged; });
    }
    if (answer.hits && !answer.hits->empty()) {
      expect_other(answer, [&](CaseAnswer& a) { next(a.hits->back().distance); });
      expect_other(answer, [&](CaseAnswer& a) { next(a.hits->back().normal.z()); });
      expect_other(answer, [&](CaseAnswer& a) { a.hits->back().triangle ^= 1; });
      expect_other(answer, [&](CaseAnswer& a) { a.hits->pop_back(); });
    }
    if (answer.manifold && !answer.manifold->empty()) {
      ASSERT_TRUE(answer.manifold->front().point_a && answer.manifold->front().point_b);
      expect_other(answer, [&](CaseAnswer& a) { next(a.manifold->front().depth); });
      expect_other(answer, [&](CaseAnswer& a) { next(a.manifold->front().point_a->x()); });
      expect_other(answer, [&](CaseAnswer& a) { next(a.manifold->front().point_b->z()); });
      CaseAnswer older = answer;  // of a file that does not name the points
      older.manifold->front().point_a.reset();
      older.manifold->front().point_b.reset();
      EXPECT_TRUE(is_same(answer, older) && is_same(older, answer));
      expect_other(answer, [&](CaseAnswer& a) { a.manifold->front().feature.b ^= 1ULL << 63; });
    }
    if (answer.corners && !answer.corners->empty()) {
      expect_other(answer, [&](CaseAnswer& a) { next(a.corners->front().y()); });
    }
    if (!answer.intersection) continue;
    const CaseIntersection& parts = *answer.intersection;
    if (!parts.points.empty()) {
      expect_other(answer, [&](CaseAnswer& a) { next(a.intersection->points[0].position.x()); });
      expect_other(answer, [](CaseAnswer& a) {
        Feature& feature = a.intersection->points[0].feature_b;
        feature = feature == Feature::Edge ? Feature::Face : Feature::Edge;
      });
    }
    if (!parts.curves.empty()) {
      expect_other(answer, [](CaseAnswer& a) {
        a.intersection->curves[0].is_closed = !a.intersection->curves[0].is_closed;
      });
      expect_other(answer, [](CaseAnswer& a) { ++a.intersection->curves[0].segments[0].to; });
      expect_other(answer, [](CaseAnswer& a) {
        ++a.intersection->curves[0].segments.back().pairs.back().b;
      });
    }
    if (!parts.patches.empty()) {
      expect_other(answer, [](CaseAnswer& a) { ++a.intersection->patches[0][0].corners[0]; });
    }
    if (!parts.touching_points.empty()) {
      expect_other(answer, [](CaseAnswer& a) { ++a.intersection->touching_points[0].point; });
    }
  }
  EXPECT_GT(changed, 20u);
}

TEST_F(Cases, ADistanceBeyondTheLargestDoubleComesBack) {
  const Triangle low{{-1.7e308, -1.7e308, 0}, {-1.6e308, -1.7e308, 0}, {-1.7e308, -1.6e308, 0}};
  const Triangle high{{1.7e308, 1.7e308, 0}, {1.6e308, 1.7e308, 0}, {1.7e308, 1.6e308, 0}};
  const Case query = to_case(low, high, distance(low, high));
  ASSERT_TRUE(std::isinf(*query.answer->distance));
  const std::string text = to_json(query);
  EXPECT_NE(text.find("\"distance\":\"infinite\""), text.npos) << text;
  EXPECT_TRUE(is_same(*parse_case(text, "memory").answer, *query.answer));
  const Ray ray{{-1.7e308, -1.7e308, -1.7e308}, {1, 1, 1}};
  const Triangle there{{1.7e308, 1.7e308, 1.7e308}, {1.7e308, 0, 1.7e308}, {0, 1.7e308, 1.7e308}};
  const Case shot = to_case(there, ray, cast_ray(there, ray));
  ASSERT_EQ(shot.answer->hits->size(), 1u);
  ASSERT_TRUE(std::isinf(shot.answer->hits->front().distance));
  const Case back = parse_case(to_json(shot), "memory");
  EXPECT_TRUE(is_same(answer_case(back), *shot.answer));
  RayHit beyond = shot.answer->hits->front();
  beyond.point.x() *= 2;
  EXPECT_THROW(answer_of(std::optional(beyond)), InputError);
}

TEST_F(Cases, OneMeshTwiceIsOneHandle) {
  const Case query = to_case({torus_}, {torus_, pose_}, true);
  const std::string text = to_json(query);
  EXPECT_NE(text.find("\"same_as\": \"a\""), std::string::npos);
  const Case back = parse_case(text, "memory");
  EXPECT_TRUE(std::get<CaseMesh>(back.a).mesh == std::get<CaseMesh>(*back.b).mesh);
}

TEST_F(Cases, MeshesByFileAreReadWithTheirHash) {
  const tests::TemporaryDirectory folder;
  folder.write("t.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const CaseMesh mesh = case_mesh_of_file(folder.path(), "t.off", pose_);
  const Case query = to_case(CaseShape(mesh), Sphere{{0, 0, 0}, 1}, false);
  const std::string path = folder.path("case.json");
  write_case(path, query);
  const Case back = read_case(path);
  EXPECT_EQ(std::get<CaseMesh>(back.a).file->sha256, mesh.file->sha256);
  EXPECT_EQ(to_json(back), to_json(query));
}

TEST_F(Cases, BodiesOfEveryKindComeBack) {
  const std::vector<Eigen::Vector3d> corners = {{0, 0, 0}, {0.75, 0, 0}, {0, 0.5, 0}, {0, 0, 3}};
  const std::vector<Shape> shapes = {
      Sphere{{0.1, 0, 0}, 0.7}, Box{{0.1, 0.2, 0.3}},
      Capsule{0.3, 0},          Cylinder{0.1, 0.9},
      Cone{0.3, 0.7},           Ellipsoid{{0, 0.1, 0}, {0.1, 0.2, 0.3}},
      ConvexHull(corners),      HalfSpace{{0, -1, 0}, -0.3},
      Plane{{0, 1, 0.5}, 0.1},  Mesh(corners, std::vector<TriangleIndices>{{0, 1, 3}})};
  std::set<bool> answers;
  for (const Shape& shape_a : shapes) {
    for (const Shape& shape_b : shapes) {
      const Pose here = Pose::Identity();
      const bool says = intersects({shape_a, here}, {shape_b, pose_});
      answers.insert(says);
      const Case query =
          to_case(CaseShape(CaseBody(shape_a, here)), CaseBody(shape_b, pose_), says);
      const Case back = parse_case(to_json(query), "memory");
      EXPECT_EQ(to_json(back), to_json(query));
      EXPECT_EQ(std::get<CaseBody>(back.a).shape.kind(), shape_a.kind());
      EXPECT_EQ(answer_case(back).says, says) << name_of(shape_a.kind()) << name_of(shape_b.kind());
    }
  }
  EXPECT_EQ(answers.size(), 2u);
  const CaseBody ball(shapes[0], pose_);
  const Case with_volume = to_case(CaseShape(ball), Sphere{{0, 0, 0}, 1}, false);
  EXPECT_THROW(answer_case(with_volume), InputError) << "a body and a volume";
  EXPECT_THROW(parse_case(to_json(with_volume), "memory"), CaseError);
}

TEST_F(Cases, ACutListIsACaseWithItsLimitAlone) {
  const TrianglePairs cut = find_triangle_pairs(a(), b(pose_), {.limit = 1});
  EXPECT_THROW(to_case(a(), b(pose_), cut), InputError) << "no limit in the settings";
  const PairSettings by_boxes{.limit = 1, .volume = PairVolume::Obb};
  EXPECT_THROW(to_case(a(), b(pose_), cut, by_boxes), InputError) << "another volume finds others";
  const MeshContacts few = find_contacts(a(), b(pose_), {.limit = 0});
  EXPECT_THROW(to_case(a(), b(pose_), few), InputError);
}

}  // namespace
}  // namespace graze
