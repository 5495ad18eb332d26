// The value: what is stored, what is refused, and what is said of it without any query.

#include <graze/bvh/error.h>
#include <graze/engine/world/height_field.h>
#include <graze/engine/world/shape.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/engine/height_fields/random_fields.h"

namespace graze {
namespace {

using tests::FieldParts;
using tests::Ground;

const float kNan = std::numeric_limits<float>::quiet_NaN();

FieldParts four_by_three() {
  FieldParts parts;
  parts.columns = 4, parts.rows = 3;
  parts.heights = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  parts.settings = {.spacing_x = 0.5, .spacing_y = 2, .height_scale = 0.1, .height_offset = -7};
  return parts;
}

void expect_refused(const FieldParts& parts, const std::string& says) {
  try {
    const HeightField field = parts.field();
    ADD_FAILURE() << "taken, but should say: " << says;
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), "height field: " + says);
  }
}

TEST(HeightField, PointsAreWhatTheirHeightsSayToTheBit) {
  const HeightField field = four_by_three().field();
  EXPECT_EQ(field.columns(), 4u);
  EXPECT_EQ(field.rows(), 3u);
  for (std::uint32_t r = 0; r < 3; ++r) {
    for (std::uint32_t c = 0; c < 4; ++c) {
      const volatile double scaled = 0.1 * (4 * r + c);  // rounded, whatever the compiler does
      EXPECT_EQ(field.vertex(c, r), Eigen::Vector3d(0.5 * c, 2.0 * r, scaled - 7));
    }
  }
  EXPECT_EQ(field.bounds(), (Aabb{field.vertex(0, 0), field.vertex(3, 2)}));
}

TEST(HeightField, TrianglesLieAlongTheDiagonalThatGoesUpAndFaceUp) {
  const HeightField field = four_by_three().field();
  const Triangle first = field.triangle(2 * (1 * 3 + 2)),
                 second = field.triangle(2 * (1 * 3 + 2) + 1);
  const auto v = [&](std::uint32_t c, std::uint32_t r) { return field.vertex(c, r); };
  EXPECT_EQ(first, (Triangle{v(2, 1), v(3, 1), v(3, 2)}));
  EXPECT_EQ(second, (Triangle{v(2, 1), v(3, 2), v(2, 2)}));
  for (const Triangle& t : {first, second})
    EXPECT_GT((t.b - t.a).cross(t.c - t.a).z(), 0);
}

TEST(HeightField, ItsMeshHasAllVerticesAndTheTrianglesThatAreNoHoles) {
  FieldParts parts = four_by_three();
  parts.holes = {0, 1, 0, 0, 0, 1};
  const HeightField field = parts.field();
  const Mesh mesh = field.mesh();
  EXPECT_EQ(mesh.vertices().size(), 12u);
  ASSERT_EQ(mesh.triangles().size(), 8u);
  EXPECT_EQ(mesh.bounds(), field.bounds());
  const std::uint32_t numbers[] = {0, 1, 4, 5, 6, 7, 8, 9};
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_EQ(mesh.triangle(i), field.triangle(numbers[i]));
}

TEST(HeightField, BoundsLeaveOutWhatOnlyHolesHave) {
  FieldParts parts = four_by_three();
  parts.heights[0] = -100;
  parts.holes = {1, 0, 0, 1, 0, 0};
  const HeightField field = parts.field();
  EXPECT_EQ(field.bounds(), field.mesh().bounds());
  EXPECT_EQ(field.bounds().min.x(), 0.5);
}

TEST(HeightField, ManyTilesHaveTheBoundsOfTheirMesh) {
  RandomSource source(1);
  FieldParts parts;
  parts.columns = 300, parts.rows = 260;
  for (std::uint32_t i = 0; i < parts.columns * parts.rows; ++i)
    parts.heights.push_back(static_cast<float>(source.uniform(-5, 5)));
  parts.holes.assign(299 * 259, 0);
  for (std::size_t i = 0; i < parts.holes.size(); ++i)
    parts.holes[i] = i % 299 < 130 || source.integer(0, 2) == 0;
  const HeightField field = parts.field();
  EXPECT_EQ(field.bounds(), field.mesh().bounds());
}

TEST(HeightField, SixteenBitHeightsAreTheSameSurfaceAsTheirFloats) {
  const HeightField floats = four_by_three().field(), shorts = four_by_three().short_field();
  for (std::uint32_t r = 0; r < 3; ++r) {
    for (std::uint32_t c = 0; c < 4; ++c)
      EXPECT_EQ(floats.vertex(c, r), shorts.vertex(c, r));
  }
}

TEST(HeightField, MaterialsAreThoseOfTheirCells) {
  FieldParts parts = four_by_three();
  EXPECT_EQ(parts.field().material(2, 1), 0);
  parts.materials = {1, 2, 3, 4, 5, 255};
  const HeightField field = parts.field();
  EXPECT_EQ(field.material(1, 0), 2);
  EXPECT_EQ(field.material(2, 1), 255);
}

TEST(HeightField, TakesFourBytesForAFloatTwoForSixteenBitsAndAnEighthForAll) {
  FieldParts parts;
  parts.columns = parts.rows = 1024;
  parts.heights.assign(std::size_t{1024} * 1024, 1);
  const double cells = 1023.0 * 1023;
  // And some hundred bytes for each of 64 tiles, and the heights of a row and a column more.
  EXPECT_LT(static_cast<double>(parts.field().bytes()) / cells, 4.16);
  EXPECT_LT(static_cast<double>(parts.short_field().bytes()) / cells, 2.16);
  parts.materials.assign(std::size_t{1023} * 1023, 3);
  EXPECT_LT(static_cast<double>(parts.short_field().bytes()) / cells, 3.17);
  parts.holes.assign(std::size_t{1023} * 1023, 1);
  parts.holes[5] = 0;
  EXPECT_LT(static_cast<double>(parts.short_field().bytes()) / cells, 3.3);
}

TEST(HeightField, OtherHeightsInAPartAreAFieldOfThese) {
  RandomSource source(2);
  for (int n = 0; n < 40; ++n) {
    FieldParts parts;
    parts.columns = static_cast<std::uint32_t>(source.integer(120, 270));
    parts.rows = static_cast<std::uint32_t>(source.integer(2, 140));
    for (std::uint32_t i = 0; i < parts.columns * parts.rows; ++i)
      parts.heights.push_back(static_cast<float>(source.uniform(-1, 1)));
    const HeightField before = parts.field();
    FieldRange part;
    part.first_column =
        static_cast<std::uint32_t>(source.integer(0, static_cast<int>(parts.columns) - 1));
    part.first_row =
        static_cast<std::uint32_t>(source.integer(0, static_cast<int>(parts.rows) - 1));
    part.columns = static_cast<std::uint32_t>(
        source.integer(1, static_cast<int>(parts.columns - part.first_column)));
    part.rows = static_cast<std::uint32_t>(
        source.integer(1, static_cast<int>(parts.rows - part.first_row)));
    std::vector<float> heights;
    for (std::uint32_t i = 0; i < part.columns * part.rows; ++i) {
      heights.push_back(static_cast<float>(source.uniform(-3, 3)));
      parts.heights[(part.first_row + i / part.columns) * parts.columns + part.first_column +
                    i % part.columns] = heights.back();
    }
    const HeightField after = before.with_heights(part, std::span<const float>(heights));
    const HeightField anew = parts.field();
    EXPECT_EQ(after.bounds(), anew.bounds());
    EXPECT_EQ(after.mesh().bounds(), anew.bounds());
    for (std::uint32_t r = 0; r < parts.rows; ++r) {
      for (std::uint32_t c = 0; c < parts.columns; ++c)
        ASSERT_EQ(after.vertex(c, r), anew.vertex(c, r)) << n;
    }
  }
}

TEST(Law10HeightField, TheDoorNamesWhatItRefuses) {
  FieldParts parts = four_by_three();
  parts.heights[6] = kNan;
  expect_refused(parts, "the height in column 2, row 1 is not finite");
  parts.heights[6] = std::numeric_limits<float>::infinity();
  expect_refused(parts, "the height in column 2, row 1 is not finite");
  parts.heights[6] = 1;
  parts.settings.height_scale = 1e100;
  expect_refused(parts, "the height in column 2, row 0 is beyond the largest length");
  parts.settings.height_scale = 0;
  expect_refused(parts, "the scale of heights is 0.000000, but must be finite and above 0");
  parts = four_by_three();
  parts.columns = 1;
  expect_refused(parts, "1 columns and 3 rows, but there must be 2 of each");
  parts = four_by_three();
  parts.heights.pop_back();
  expect_refused(parts, "11 heights, not 12");
  parts = four_by_three();
  parts.holes = {1, 0};
  expect_refused(parts, "2 holes, not 6");
  parts.holes.assign(6, 1);
  expect_refused(parts, "all cells are holes");
  parts.holes.clear();
  parts.materials = {1};
  expect_refused(parts, "1 materials, not 6");
  parts = four_by_three();
  parts.settings.spacing_y = -1;
  expect_refused(
      parts, "the spacing in y is -1.000000, but must be finite and at least the smallest length");
  parts.settings.spacing_y = 1e100;
  expect_refused(parts, "with this spacing in y it reaches beyond the largest length");
  parts = four_by_three();
  parts.settings.height_offset = std::numeric_limits<double>::quiet_NaN();
  expect_refused(parts, "the offset of heights is not finite or beyond the largest length");
  parts = four_by_three();
  parts.columns = parts.rows = 1u << 15;
  expect_refused(parts, "2^29 heights or more");
}

TEST(Law10HeightField, APartMustBeOne) {
  const HeightField field = four_by_three().field();
  const std::vector<float> two = {1, kNan};
  const auto refusal = [&](const FieldRange& part) -> std::string {
    try {
      field.with_heights(part, std::span<const float>(two));
      return "taken";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(refusal({3, 0, 2, 1}),
            "height field: columns 3 to 5 and rows 0 to 1 are no part of 4 columns and 3 rows");
  EXPECT_EQ(refusal({0, 0, 0, 1}),
            "height field: columns 0 to 0 and rows 0 to 1 are no part of 4 columns and 3 rows");
  EXPECT_EQ(refusal({0xffffffffu, 0, 2, 1}),
            "height field: columns 4294967295 to 4294967297 and rows 0 to 1 are no part of 4 "
            "columns and 3 rows");
  EXPECT_EQ(refusal({0, 0, 3, 1}), "height field: 2 heights, not 3");
  EXPECT_EQ(refusal({2, 1, 2, 1}), "height field: the height in column 3, row 1 is not finite");
  const std::vector<std::uint16_t> shorts = {1, 2};
  EXPECT_THROW(field.with_heights({0, 0, 2, 1}, std::span<const std::uint16_t>(shorts)),
               InputError);
}

}  // namespace
}  // namespace graze
