// Queries as files: nothing is lost on the way, and they can be asked again.

#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/case_mesh_file.h>
#include <graze/engine/cases/hex_float.h>
#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/sha256.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/mesh/containment.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <graze/narrowphase/volumes/obb_overlap.h>
#include <graze/narrowphase/volumes/sphere_box.h>
#include <graze/narrowphase/volumes/sphere_overlap.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>
#include <gtest/gtest.h>
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

using cases::parse_hex_float;
using cases::to_hex_float;

TEST(CaseNumbers, EveryDoubleComesBackBitForBit) {
  std::uint64_t bits = 1;
  for (int i = 0; i < 20000; ++i) {
    bits = bits * 6364136223846793005U + 1442695040888963407U;
    const auto value = std::bit_cast<double>(bits);
    if (!std::isfinite(value)) continue;
    const std::optional<double> back = parse_hex_float(to_hex_float(value));
    ASSERT_TRUE(back) << to_hex_float(value);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*back), bits);
  }
  using Limits = std::numeric_limits<double>;
  for (double value : {0.0, -0.0, Limits::denorm_min(), Limits::min(), Limits::max(), -1.0, 0.1,
                       std::nextafter(Limits::min(), 0.0)}) {
    const std::optional<double> back = parse_hex_float(to_hex_float(value));
    ASSERT_TRUE(back) << to_hex_float(value);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(value));
  }
  EXPECT_EQ(to_hex_float(3.0), "0x1.8p+1");
  EXPECT_EQ(to_hex_float(-0.0), "-0x0p+0");
}

TEST(CaseNumbers, OtherSpellingsOfADoubleAreRead) {
  EXPECT_EQ(parse_hex_float("0x3p0"), 3.0);
  EXPECT_EQ(parse_hex_float("+0X0.00018P+17"), 3.0);
  EXPECT_EQ(parse_hex_float("0x1800000000000000000000p-83"), 3.0);
  EXPECT_EQ(parse_hex_float("0x0.0000000000001p-1022"), 0x1p-1074);
}

TEST(CaseNumbers, WhatIsNoDoubleIsRefused) {
  for (const char* text : {"",
                           "1",
                           "0x",
                           "0xp1",
                           "0x1",
                           "0x1p",
                           "0x1p+-1",
                           "0x1p1 ",
                           " 0x1p1",
                           "nan",
                           "inf",
                           "0xinf",
                           "0x1p+1024",
                           "0x1p-1075",
                           "0x1.00000000000008p+0",
                           "0x3p-1075",
                           "0x1p99999999999",
                           "1.5",
                           "--0x1p1",
                           "0x1..8p1",
                           "0x1ffffffffffffffffffp0"}) {
    EXPECT_EQ(parse_hex_float(text), std::nullopt) << text;
  }
}

TEST(CaseHashes, AreThoseOfTheStandard) {
  EXPECT_EQ(cases::sha256_of(""),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(cases::sha256_of("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(cases::sha256_of(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

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
    const Separation apart = separating_translation(a(), b(pose_));
    return {to_case(a(), b(pose_), intersects(a(), b(pose_))),
            to_case(a(), b(far_), intersects(a(), b(far_), {.interior = Interior::Solid}),
                    {.interior = Interior::Solid}),
            to_case(a(), b(pose_), intersects(a(), b(pose_), {.touch = Touch::Exclude}),
                    {.touch = Touch::Exclude}),
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
            to_case(box, obb, overlaps(box, obb)),
            to_case(ball, ball, overlaps(ball, ball)),
            to_case(ball, obb, overlaps(ball, obb)),
            to_case_contains(sphere_, Eigen::Vector3d(0, 0, 0.5), contains(sphere_, {0, 0, 0.5})),
            to_case_self(torus_, self_intersects(torus_)),
            to_case_self(torus_, find_self_pairs(torus_)),
            to_case({torus_}, {torus_, pose_}, find_triangle_pairs({torus_}, {torus_, pose_}))};
  }

  Mesh torus_ = tests::make_torus(1, 0.3, 20, 12);
  Mesh sphere_ = tests::make_sphere(0.75, 9, 13);
  Pose pose_ = Pose::Identity();
  Pose far_ = Pose::Identity();
};

TEST_F(Cases, EveryQueryWritesItselfAndComesBack) {
  std::set<Ask> asked;
  for (const Case& query : all_queries()) {
    asked.insert(query.ask);
    const std::string text = to_json(query);
    SCOPED_TRACE(text.substr(0, 60));
    const Case back = parse_case(text, "memory");
    EXPECT_EQ(to_json(back), text);
    EXPECT_TRUE(is_same(*back.answer, *query.answer));
    EXPECT_TRUE(is_same(answer_case(back), *query.answer));
    EXPECT_EQ(back.answered_by.engine, "graze");
  }
  EXPECT_EQ(asked.size(), 9u);
}

TEST_F(Cases, ReplayBitForBitOnEverySimdTarget) {
  for (const Case& query : all_queries()) {
    const Case back = parse_case(to_json(query), "memory");
    for (const std::int64_t target : narrowphase::simd_targets()) {
      narrowphase::force_simd_target(target);
      EXPECT_TRUE(is_same(answer_case(back), *query.answer)) << name_of(query.ask) << " " << target;
    }
    narrowphase::force_simd_target(0);
  }
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
  const std::vector<Shape> shapes = {Sphere{{0.1, 0, 0}, 0.7},
                                     Box{{0.1, 0.2, 0.3}},
                                     Capsule{0.3, 0},
                                     Cylinder{0.1, 0.9},
                                     Cone{0.3, 0.7},
                                     Ellipsoid{{0, 0.1, 0}, {0.1, 0.2, 0.3}},
                                     ConvexHull(corners),
                                     HalfSpace{{0, -1, 0}, -0.3},
                                     Mesh(corners, std::vector<TriangleIndices>{{0, 1, 3}})};
  std::set<bool> answers;
  for (const Shape& shape_a : shapes) {
    for (const Shape& shape_b : shapes) {
      const Pose here = Pose::Identity();
      const bool says = intersects(shape_a, here, shape_b, pose_);
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

TEST_F(Cases, ACutListIsNoCase) {
  const TrianglePairs cut = find_triangle_pairs(a(), b(pose_), {.limit = 1});
  EXPECT_THROW(to_case(a(), b(pose_), cut), InputError);
}

}  // namespace
}  // namespace graze
