// The bundled files are what their generator writes, and it follows the standards it cites.

#include <gtest/gtest.h>

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/pose_text.h>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>

#include "data/generator/generate.h"
#include "data/generator/parts/gear.h"
#include "data/generator/parts/thread_profile.h"
#include "data/generator/parts/tolerances.h"
#include "tests/files/temporary_directory.h"

namespace graze {
namespace {

using namespace generator;

const std::filesystem::path kData = GRAZE_DATA_DIR;

// The C library's sine may differ in the last place from machine to machine: equal to 1e-12 of the
// largest coordinate, and to a rounding of float for the nut, which is stored in floats.
void expect_same_mesh(const std::filesystem::path& path_a, const std::filesystem::path& path_b) {
  const Mesh a = load_mesh(path_a);
  const Mesh b = load_mesh(path_b);
  ASSERT_EQ(a.vertices().size(), b.vertices().size());
  EXPECT_TRUE(std::ranges::equal(a.triangles(), b.triangles()));
  const double size = a.bounds().max.cwiseMax(-a.bounds().min).maxCoeff();
  const double tolerance = size * (path_a.extension() == ".stl" ? 0x1p-23 : 1e-12);
  double largest = 0;
  for (std::size_t i = 0; i < a.vertices().size(); ++i) {
    largest = std::max(largest, (a.vertices()[i] - b.vertices()[i]).cwiseAbs().maxCoeff());
  }
  EXPECT_LE(largest, tolerance);
}

// What is made without the C library's sine: the same bytes on every machine.
bool has_no_sine(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  return name.starts_with("link") || name.starts_with("rock") || name.starts_with("terrain");
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void expect_same_poses(const std::filesystem::path& path_a, const std::filesystem::path& path_b) {
  const auto a = load_poses(path_a);
  const auto b = load_poses(path_b);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_TRUE(a[i].isApprox(b[i], 1e-12)) << path_a << " pose " << i;
  }
}

TEST(DataGenerator, WritesTheBundledFiles) {
  const tests::TemporaryDirectory scratch;
  const std::filesystem::path directory = scratch.path("data");
  generate(directory);
  std::size_t files = 0;
  std::size_t same_bytes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
    if (entry.is_directory()) continue;
    const auto name = std::filesystem::relative(entry.path(), directory);
    SCOPED_TRACE(name);
    ++files;
    if (has_no_sine(name)) {
      ++same_bytes;
      EXPECT_TRUE(bytes_of(entry.path()) == bytes_of(kData / name));
    } else if (name.extension() == ".txt") {
      expect_same_poses(entry.path(), kData / name);
    } else {
      expect_same_mesh(entry.path(), kData / name);
    }
  }
  EXPECT_EQ(files, 34u);
  EXPECT_EQ(same_bytes, 16u);
}

// ISO 965-1, tables for M8 with pitch 1.25: es of g, Td and Td2 of grade 6, TD2 and TD1 of grade 6.
TEST(DataGenerator, TolerancesAreThoseOfTheTables) {
  const ThreadTolerances t = tolerances_6h_6g(1.25, std::sqrt(5.6 * 11.2));
  EXPECT_NEAR(t.external_major.upper, -0.028, 1e-9);
  EXPECT_NEAR(t.external_major.lower, -0.028 - 0.212, 1e-9);
  EXPECT_NEAR(t.external_pitch.lower, -0.028 - 0.118, 1e-9);
  EXPECT_NEAR(t.internal_pitch.upper, 0.160, 1e-9);
  EXPECT_NEAR(t.internal_minor.upper, 0.265, 1e-9);
}

// The root's arc begins where the flank ends and in the flank's direction: 30 degrees to the
// radius.
TEST(DataGenerator, FlanksOfTheThreadStandAtThirtyDegrees) {
  for (const ThreadProfile& profile : {external_profile(kM8, std::sqrt(5.6 * 11.2)),
                                       internal_profile(kM8, std::sqrt(5.6 * 11.2))}) {
    int flanks = 0;
    for (std::size_t i = 0; i < profile.points.size(); ++i) {
      const bool is_last = i + 1 == profile.points.size();
      const ThreadPoint& p = profile.points[i];
      ThreadPoint q = profile.points[is_last ? 0 : i + 1];
      if (is_last) q.z += profile.pitch;
      EXPECT_GT(q.z, p.z);
      if (std::abs(q.r - p.r) < 0.3) continue;
      ++flanks;
      EXPECT_NEAR((q.z - p.z) / std::abs(q.r - p.r), std::tan(std::numbers::pi / 6), 1e-12);
    }
    EXPECT_EQ(flanks, 2);
  }
}

TEST(DataGenerator, FilletAndInvoluteMeet) {
  for (const SpurGear& gear : {kGear.gear, kPinion.gear}) {
    const auto fine = flank(gear, 1000, 1);
    // The fillet's last of 1000 steps comes as near to the involute's first point as a step is
    // long.
    const FlankPoint& before = fine[999];
    const FlankPoint& joint = fine[1000];
    EXPECT_NEAR(joint.radius, gear.form_radius(), 1e-12);
    EXPECT_NEAR(before.radius, joint.radius, 0.01);
    EXPECT_NEAR(before.angle * before.radius, joint.angle * joint.radius, 0.01);
    for (std::size_t i = 1; i < fine.size(); ++i) {
      ASSERT_GT(fine[i].radius, fine[i - 1].radius) << i;
      ASSERT_LT(fine[i].angle, fine[i - 1].angle) << i;
    }
  }
}

// On the reference circle a tooth is half a pitch thick, less the thinning.
TEST(DataGenerator, TeethHaveTheirThickness) {
  for (const SpurGear& gear : {kGear.gear, kPinion.gear}) {
    const auto fine = flank(gear, 1, 100000);
    const auto on_circle =
        std::ranges::lower_bound(fine, gear.reference_radius(), {}, &FlankPoint::radius);
    EXPECT_NEAR(2 * on_circle->angle * gear.reference_radius(),
                std::numbers::pi * gear.module / 2 - gear.thinning, 1e-4);
    EXPECT_EQ(fine.front().radius, gear.root_radius());
    EXPECT_NEAR(fine.back().radius, gear.tip_radius(), 1e-12);
  }
}

TEST(DataGenerator, TooFewTeethAreRefused) {
  EXPECT_THROW((SpurGear{17, 2, 0}.form_radius()), std::domain_error);
  EXPECT_NO_THROW((SpurGear{18, 2, 0}.form_radius()));
}

}  // namespace
}  // namespace graze
