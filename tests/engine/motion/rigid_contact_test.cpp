// Law 14, when bodies meet: what is called free beside poses that intersects() is asked about, and
// times that are known.

#include <graze/bvh/error.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/pose_text.h>
#include <graze/engine/print.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

constexpr double kHalfTurn = std::numbers::pi;

bool is_hit(const Mesh& a, const RigidMotion& motion_a, const Mesh& b, const RigidMotion& motion_b,
            double t, double clearance) {
  const PlacedMesh placed_a{a, motion_a.at(t)}, placed_b{b, motion_b.at(t)};
  return clearance == 0 ? intersects(placed_a, placed_b) : within(placed_a, placed_b, clearance);
}

/// What law 14 says of an answer, as far as samples can tell.
void expect_sound(const Mesh& a, const RigidMotion& motion_a, const Mesh& b,
                  const RigidMotion& motion_b, const RigidContactSettings& settings,
                  int samples = 200) {
  const RigidContact found = first_contact({a, motion_a}, {b, motion_b}, settings);
  const auto hits = [&](double t) {
    return is_hit(a, motion_a, b, motion_b, t, settings.clearance);
  };
  for (int i = 0; i <= samples; ++i) {
    const double t = found.low * i / samples;
    if (t == found.low && found.low < 1) break;
    ASSERT_FALSE(hits(t)) << "at " << t << " of " << found.low;
  }
  if (found.status == RigidStatus::Free) {
    EXPECT_EQ(found.low, 1);
  } else {
    ASSERT_LT(found.low, 1);
    const double apart =
        distance({a, motion_a.at(found.low)}, {b, motion_b.at(found.low)}).distance;
    EXPECT_LE(apart, settings.clearance + settings.tolerance);
  }
  if (found.status == RigidStatus::Hit) {
    EXPECT_LE(found.low, found.high);
    EXPECT_TRUE(hits(found.high));
  }
  EXPECT_FALSE(found.is_out_of_budget);

  const RigidContact mirrored = first_contact({b, motion_b}, {a, motion_a}, settings);
  EXPECT_EQ(found, mirrored);
  EXPECT_EQ(is_free({a, motion_a}, {b, motion_b}, settings), found.status == RigidStatus::Free);
  const auto last = last_free({a, motion_a}, {b, motion_b}, settings);
  EXPECT_EQ(last.has_value(), found.low > 0);
  if (last) {
    EXPECT_TRUE(found.status == RigidStatus::Free ? *last == 1 : *last < found.low);
  }
}

RigidMotion random_motion(RandomSource& source, double reach, double most_turned) {
  const Pose start = tests::random_pose(reach, source);
  switch (static_cast<int>(source.integer(0, 4))) {
    case 0:
      return RigidMotion::between(start, tests::random_pose(reach, source));
    case 1:
      return RigidMotion::screw_between(start, tests::random_pose(reach, source));
    case 2:
      return RigidMotion(start);
    case 3:
      return RigidMotion(start, {.shift = source.vector(-reach, reach)});
    default:
      break;
  }
  return {start,
          {.centre = source.vector(-reach, reach),
           .shift = source.vector(-reach, reach),
           .axis = source.vector(-1, 1),
           .angle = source.uniform(-most_turned, most_turned)}};
}

TEST(Law14Contact, SamplesOfRandomMotionsNeverHitWhatIsFree) {
  RandomSource source(1410);
  int counts[3] = {0, 0, 0};
  for (int i = 0; i < 120; ++i) {
    const Mesh a = tests::random_soup({.count = 30, .extent = 0.6}, source);
    const Mesh b = i % 2 == 0 ? tests::make_box({0.25, 0.5, 0.125})
                              : tests::random_soup({.count = 20, .extent = 0.5}, source);
    const RigidMotion motion_a = random_motion(source, 1.5, 2);
    const RigidMotion motion_b = random_motion(source, 1.5, i % 10 == 0 ? 60 : 4);
    const RigidContactSettings settings{.clearance = i % 3 == 0 ? 0.01 : 0,
                                        .tolerance = i % 5 == 0 ? 1e-3 : 1e-6};
    expect_sound(a, motion_a, b, motion_b, settings);
    ++counts[static_cast<int>(first_contact({a, motion_a}, {b, motion_b}, settings).status)];
  }
  EXPECT_GT(counts[static_cast<int>(RigidStatus::Free)], 10);
  EXPECT_GT(counts[static_cast<int>(RigidStatus::Hit)], 10);
}

TEST(Law14Contact, ABoxFallsOnAPlane) {
  const Mesh plane = tests::make_box({4, 4, 0.5});
  const Mesh box = tests::make_box({0.5, 0.5, 0.5});
  const RigidMotion rest(tests::at(0, 0, -0.5));
  const RigidMotion fall(tests::at(0, 0, 2.5), {.shift = {0, 0, -4}});
  const RigidContact found = first_contact({plane, rest}, {box, fall});
  EXPECT_EQ(found.status, RigidStatus::Hit);
  EXPECT_NEAR(found.low, 0.5, 1e-6);
  EXPECT_NEAR(found.high, 0.5, 1e-6);
  EXPECT_LE(found.low, 0.5);
  EXPECT_GE(found.high, 0.5);
}

TEST(Law14Contact, TheCornerOfATurningBoxMeetsAPlane) {
  const Mesh plane = tests::make_box({4, 4, 0.5});
  const Mesh box = tests::make_box({0.5, 0.5, 0.5});
  const RigidMotion rest(tests::at(0, 0, -0.5));
  // Its lower edges reach down to sqrt(1/2) sin(45 degrees + angle) below the axis.
  const double height = 0.65;
  const RigidMotion turn(tests::at(0, 0, height),
                         {.centre = {0, 0, height}, .axis = {1, 0, 0}, .angle = kHalfTurn / 4});
  const double time = (std::asin(height / std::sqrt(0.5)) - kHalfTurn / 4) / (kHalfTurn / 4);
  const RigidContact found = first_contact({plane, rest}, {box, turn}, {.tolerance = 1e-9});
  EXPECT_EQ(found.status, RigidStatus::Hit);
  EXPECT_LE(found.low, time + 1e-15);
  EXPECT_NEAR(found.low, time, 1e-8);
  EXPECT_NEAR(found.high, time, 1e-8);
  // With a clearance it is as if the axis lay lower.
  const RigidContact near =
      first_contact({plane, rest}, {box, turn}, {.clearance = 0.05, .tolerance = 1e-9});
  EXPECT_EQ(near.status, RigidStatus::Hit);
  EXPECT_NEAR(near.high,
              (std::asin((height - 0.05) / std::sqrt(0.5)) - kHalfTurn / 4) / (kHalfTurn / 4),
              1e-8);
}

TEST(Law14Contact, ATurnThatEndsShortOfThePlaneIsFree) {
  const Mesh plane = tests::make_box({4, 4, 0.5});
  const Mesh box = tests::make_box({0.5, 0.5, 0.5});
  const RigidMotion rest(tests::at(0, 0, -0.5));
  const double height = std::sqrt(0.5) + 2e-6;
  for (const double turns : {1.0, 30.0}) {
    const RigidMotion turn(
        tests::at(0, 0, height),
        {.centre = {0, 0, height}, .axis = {1, 0, 0}, .angle = 2 * kHalfTurn * turns});
    EXPECT_EQ(first_contact({plane, rest}, {box, turn}).status, RigidStatus::Free);
    EXPECT_EQ(first_contact({plane, rest}, {box, turn}, {.tolerance = 1e-5}).status,
              RigidStatus::Close);
    EXPECT_EQ(first_contact({plane, rest}, {box, turn}, {.clearance = 2.1e-6}).status,
              RigidStatus::Hit);
  }
}

TEST(Law14Contact, BodiesThatMoveAlikeStayAsFarApart) {
  const Mesh box = tests::make_box({0.5, 0.5, 0.5});
  const RigidCourse course{.centre = {3, 1, 2}, .shift = {5, 1, 0}, .axis = {1, 2, 3}, .angle = 9};
  const RigidMotion one(tests::at(0), course);
  const RigidMotion other(tests::at(1.001), course);
  EXPECT_TRUE(is_free({box, one}, {box, other}));
  EXPECT_FALSE(is_free({box, one}, {box, other}, {.clearance = 0.00101}));
  EXPECT_EQ(first_contact({box, one}, {box, one}).status, RigidStatus::Hit);
}

TEST(Law14Contact, SpecialPositionsAreSound) {
  const Mesh box = tests::make_box({0.5, 0.5, 0.5});
  const Mesh rod = tests::make_box({2, 0.0078125, 0.0078125});
  const Mesh sheet = tests::make_box({1, 1, 0});
  const Mesh ring = tests::make_torus(1, 0.25, 24, 12);
  const RigidMotion rest(Pose::Identity());
  // A rod through a ring, along and about its axis.
  const Pose upright(Eigen::AngleAxisd(kHalfTurn / 2, Eigen::Vector3d::UnitY()) * Pose::Identity());
  const RigidMotion screw = RigidMotion::screw(upright, {.angle = 20, .pitch = 0.1});
  EXPECT_TRUE(is_free({ring, rest}, {rod, screw}));
  expect_sound(ring, rest, rod, screw, {});
  // Concentric, in contact from the start, at rest, touching faces that slide.
  expect_sound(box, rest, box, RigidMotion(Pose::Identity(), {.angle = 1}), {});
  expect_sound(box, rest, box, RigidMotion(tests::at(1), {.shift = {0, 0.5, 0}}), {});
  expect_sound(box, rest, box, RigidMotion(tests::at(1.5)), {});
  EXPECT_EQ(first_contact({box, rest}, {box, RigidMotion(tests::at(1))}).status, RigidStatus::Hit);
  EXPECT_EQ(first_contact({box, rest}, {box, RigidMotion(tests::at(1))}).high, 0);
  // Faces that slide a little apart, and nearer than the tolerance.
  EXPECT_TRUE(is_free({box, rest}, {box, RigidMotion(tests::at(1.0001), {.shift = {0, 5, 3}})}));
  EXPECT_EQ(
      first_contact({box, rest}, {box, RigidMotion(tests::at(1.0000001), {.shift = {0, 5, 3}})})
          .status,
      RigidStatus::Close);
  // Sheets without thickness that sweep past and through.
  expect_sound(sheet, rest, sheet,
               RigidMotion(tests::at(0, 0, 0.5), {.axis = {1, 0, 0}, .angle = 1.2}), {});
  expect_sound(sheet, RigidMotion(Pose::Identity(), {.axis = {1, 0, 0}, .angle = 7}), rod,
               RigidMotion(tests::at(3, 0.5, 0.25), {.shift = {-3, 0, 0}}), {});
  // Contact at the very end.
  expect_sound(box, rest, box, RigidMotion(tests::at(2), {.shift = {-1, 0, 0}}), {});
}

TEST(Law14Contact, ThinPartsThatPassQuicklyAreSeen) {
  const Mesh needle = tests::make_box({0x1p-12, 0x1p-12, 1});
  const RigidMotion rest(Pose::Identity());
  const Pose across(Eigen::AngleAxisd(kHalfTurn / 2, Eigen::Vector3d::UnitY()) * Pose::Identity());
  // Many turns of a blade about an axis beside the needle.
  const RigidMotion blade(across, {.centre = {0.5, 0.25, 0}, .angle = 300});
  const RigidContact found = first_contact({needle, rest}, {needle, blade});
  EXPECT_NE(found.status, RigidStatus::Free);
  expect_sound(needle, rest, needle, blade, {}, 20000);
}

TEST(Law14Contact, ABudgetEndsInCloseAndIsSound) {
  const Mesh a = tests::make_torus(1, 0.25, 24, 12);
  const RigidMotion rest(Pose::Identity());
  const RigidMotion motion(
      tests::at(3), {.centre = {3, 0, 0}, .shift = {-3, 0, 0}, .axis = {1, 1, 0}, .angle = 2});
  const RigidContact all = first_contact({a, rest}, {a, motion});
  ASSERT_EQ(all.status, RigidStatus::Hit);
  for (std::uint64_t budget = 0; budget < 3000; budget = budget * 2 + 1) {
    const RigidContact some = first_contact({a, rest}, {a, motion}, {.budget = budget});
    EXPECT_LE(some.low, all.low);
    EXPECT_EQ(some.is_out_of_budget, some.status == RigidStatus::Close);
    EXPECT_FALSE(is_free({a, rest}, {a, motion}, {.budget = budget}));
  }
  EXPECT_TRUE(first_contact({a, rest}, {a, motion}, {.budget = 0}).is_out_of_budget);
}

TEST(Law14Threads, BatchesAnswerAsEachMotionAlone) {
  RandomSource source(1420);
  const Mesh a = tests::make_torus(1, 0.25, 24, 12);
  const Mesh b = tests::random_soup({.count = 20, .extent = 0.5}, source);
  const RigidMotion motion_a = random_motion(source, 0.1, 1);
  std::vector<RigidMotion> motions;
  for (int i = 0; i < 60; ++i)
    motions.push_back(random_motion(source, 2, 3));
  for (const int threads : {0, 1, 2}) {
    Work work;
    const std::vector<RigidContact> found =
        first_contact({a, motion_a}, {b, motions}, {}, {.threads = threads}, &work);
    const std::vector<bool> free = is_free({a, motion_a}, {b, motions}, {}, {.threads = threads});
    ASSERT_EQ(found.size(), motions.size());
    for (std::size_t i = 0; i < motions.size(); ++i) {
      EXPECT_EQ(found[i], first_contact({a, motion_a}, {b, motions[i]}));
      EXPECT_EQ(free[i], found[i].status == RigidStatus::Free);
    }
    EXPECT_GT(work.volume_tests, 0u);
  }
  motions[7] = RigidMotion(Pose::Identity(), {.shift = {1e200, 0, 0}});
  try {
    first_contact({a, motion_a}, {b, motions});
    FAIL();
  } catch (const PoseError& error) {
    EXPECT_EQ(error.place().index, 7u);
  }
  EXPECT_THROW(is_free({a, motion_a}, {b, std::span(motions).first(1)}, {}, {.threads = -1}),
               InputError);
}

TEST(Law14Threads, BatchesOfPairsAnswerAsEachAlone) {
  RandomSource source(1421);
  const std::vector<Mesh> meshes{tests::make_torus(1, 0.25, 12, 8),
                                 tests::make_torus(0.5, 0.2, 9, 6),
                                 tests::random_soup({.count = 20, .extent = 0.5}, source)};
  std::vector<RigidPair> pairs;
  for (std::size_t i = 0; i < 30; ++i)
    pairs.push_back({{meshes[i % 3], random_motion(source, 1, 1)},
                     {meshes[i / 3 % 3], random_motion(source, 2, 3)}});
  const RigidContactSettings settings{.clearance = 0.01};
  int free_ones = 0;
  for (const int threads : {0, 1, 2}) {
    Work work;
    const std::vector<RigidContact> found =
        first_contact(pairs, settings, {.threads = threads}, &work);
    const std::vector<bool> free = is_free(pairs, settings, {.threads = threads});
    ASSERT_EQ(found.size(), pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const RigidPair& pair = pairs[i];
      EXPECT_EQ(found[i], first_contact(pair.a, pair.b, settings));
      EXPECT_EQ(free[i], found[i].status == RigidStatus::Free);
      free_ones += free[i];
    }
    EXPECT_GT(work.volume_tests, 0u);
  }
  EXPECT_GT(free_ones, 5);
  EXPECT_LT(free_ones, 85);
  EXPECT_TRUE(first_contact(std::vector<RigidPair>{}).empty());
  pairs[7].a.motion = RigidMotion(Pose::Identity(), {.shift = {1e200, 0, 0}});
  try {
    first_contact(pairs);
    FAIL();
  } catch (const PoseError& error) {
    EXPECT_EQ(error.place().index, 7u);
    EXPECT_EQ(std::string(error.what()).rfind("motion of mesh A of pair 7", 0), 0u);
  }
  pairs[7].a.motion = pairs[7].b.motion;
  EXPECT_THROW(is_free(pairs, {}, {.threads = -1}), InputError);
  EXPECT_THROW(is_free(pairs, {.clearance = -1}), InputError);
}

TEST(Law14Order, TrianglesAndVerticesInAnotherOrderChangeNothing) {
  RandomSource source(1421);
  for (int i = 0; i < 20; ++i) {
    const Mesh a = tests::random_soup({.count = 40, .extent = 0.6}, source);
    const Mesh b = tests::random_soup({.count = 30, .extent = 0.5}, source);
    std::vector<TriangleIndices> triangles(a.triangles().begin(), a.triangles().end());
    std::reverse(triangles.begin(), triangles.end());
    for (TriangleIndices& t : triangles)
      std::swap(t[0], t[2]);
    const Mesh reordered(a.vertices(), triangles);
    const RigidMotion motion_a = random_motion(source, 1.5, 2);
    const RigidMotion motion_b = random_motion(source, 1.5, 4);
    EXPECT_EQ(first_contact({a, motion_a}, {b, motion_b}),
              first_contact({reordered, motion_a}, {b, motion_b}));
  }
}

TEST(RigidContact, IsPrintedInWords) {
  const auto text = [](const RigidContact& contact) {
    std::ostringstream out;
    out << contact;
    return out.str();
  };
  EXPECT_EQ(text({RigidStatus::Free, 1, 1, false}), "free");
  EXPECT_EQ(text({RigidStatus::Hit, 0.5, 0.75, false}), "free up to 0.5, hit at 0.75");
  EXPECT_EQ(text({RigidStatus::Close, 0.5, 1, false}), "free up to 0.5, then close");
  EXPECT_EQ(text({RigidStatus::Close, 0.5, 1, true}), "free up to 0.5, out of budget");
}

TEST(Law14Door, QueriesRefuseWhatTheyCannotAnswer) {
  const Mesh box = tests::make_box({0.5, 0.5, 0.5});
  const RigidMotion rest(Pose::Identity());
  EXPECT_THROW(first_contact({box, rest}, {box, rest}, {.clearance = -1}), InputError);
  EXPECT_THROW(first_contact({box, rest}, {box, rest}, {.clearance = std::nan("")}), InputError);
  EXPECT_THROW(first_contact({box, rest}, {box, rest}, {.tolerance = -1}), InputError);
  EXPECT_THROW(is_free({box, rest}, {box, rest}, {.tolerance = std::nan("")}), InputError);
  const RigidMotion far(Pose::Identity(), {.shift = {1e200, 0, 0}});
  EXPECT_THROW(first_contact({box, rest}, {box, far}), PoseError);
  EXPECT_THROW(last_free({box, far}, {box, rest}), PoseError);
}

/// The bundled gears roll over a pitch, each about its own axis, with the backlash that their page
/// states: 0.04 mm on either side, on a pitch circle of 19 mm.
TEST(Law14Bundled, GearsRollOverAPitchAndBindAtTheirBacklash) {
  const std::filesystem::path data = GRAZE_DATA_DIR;
  const Mesh gear = load_mesh(data / "meshes/gear.ply");
  const Mesh pinion = load_mesh(data / "meshes/pinion.off");
  const Pose start = load_poses(data / "poses/gear-pinion.mesh.txt").front();
  const double pitch = 2 * kHalfTurn / 31;
  const auto turned = [&](double angle) {
    return RigidMotion(start, {.centre = start.translation(), .angle = angle});
  };
  const RigidMotion rolls(Pose::Identity(), {.angle = -pitch});
  EXPECT_TRUE(is_free({gear, rolls}, {pinion, turned(pitch * 31 / 19)}));
  EXPECT_FALSE(is_free({gear, rolls}, {pinion, turned(pitch * 31 / 19 * 1.2)}));
  const RigidContact bound = first_contact({gear, RigidMotion(Pose::Identity())},
                                           {pinion, turned(0.1)}, {.tolerance = 1e-8});
  EXPECT_EQ(bound.status, RigidStatus::Hit);
  EXPECT_NEAR(0.1 * bound.high, 0.04e-3 / 19e-3, 0.00025);
  EXPECT_NEAR(bound.low, bound.high, 1e-5);
}

/// With the lead that it has the nut turns freely; with a fifth more it binds when that has used up
/// the play along the axis, 0.042 mm across flanks that stand at 30 degrees.
TEST(Law14Bundled, ANutBindsWhenItsLeadIsOff) {
  const std::filesystem::path data = GRAZE_DATA_DIR;
  const Mesh bolt = load_mesh(data / "meshes/bolt.obj");
  const Mesh nut = load_mesh(data / "meshes/nut.stl");
  const std::vector<Pose> turning = load_poses(data / "poses/bolt-nut.turning.txt");
  const RigidMotion rest(Pose::Identity());
  const Eigen::Vector3d axis = RigidMotion::between(turning[0], turning[1]).axis();
  const auto turned = [&](double lead, double turns) {
    return RigidMotion::screw(turning[0],
                              {.axis = axis, .angle = 2 * kHalfTurn * turns, .pitch = lead});
  };
  EXPECT_TRUE(is_free({bolt, rest}, {nut, turned(1.25e-3, 0.45)}));
  const RigidContact bound = first_contact({bolt, rest}, {nut, turned(1.5e-3, 0.45)});
  EXPECT_EQ(bound.status, RigidStatus::Hit);
  const double play = 0.042e-3 / std::cos(kHalfTurn / 6);
  EXPECT_NEAR(0.25e-3 * 0.45 * bound.high, play, 0.05 * play);
}

}  // namespace
}  // namespace graze
