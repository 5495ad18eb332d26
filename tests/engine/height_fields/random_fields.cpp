#include "tests/engine/height_fields/random_fields.h"

#include <algorithm>
#include <cmath>

#include "tests/shapes/random_meshes.h"

namespace graze::tests {

using Eigen::Vector3d;

namespace {

HeightFieldSettings with_lists(const FieldParts& parts) {
  HeightFieldSettings settings = parts.settings;
  settings.holes = parts.holes;
  settings.materials = parts.materials;
  return settings;
}

}  // namespace

HeightField FieldParts::field() const {
  return HeightField(columns, rows, std::span<const float>(heights), with_lists(*this));
}

HeightField FieldParts::short_field() const {
  std::vector<std::uint16_t> shorts;
  for (const float height : heights)
    shorts.push_back(static_cast<std::uint16_t>(height));
  return HeightField(columns, rows, std::span<const std::uint16_t>(shorts), with_lists(*this));
}

FieldParts random_parts(Ground ground, RandomSource& source) {
  FieldParts parts;
  parts.columns = static_cast<std::uint32_t>(source.integer(2, 24));
  parts.rows = static_cast<std::uint32_t>(source.integer(2, 24));
  parts.settings.spacing_x = source.integer(0, 1) != 0 ? 0.5 : source.uniform(0.2, 1.5);
  parts.settings.spacing_y = source.integer(0, 1) != 0 ? 0.5 : source.uniform(0.2, 1.5);
  parts.settings.height_scale = source.integer(0, 1) != 0 ? 0.25 : source.uniform(0.1, 1);
  parts.settings.height_offset = source.integer(0, 1) != 0 ? 0 : source.uniform(-3, 3);
  const double slope_x = source.integer(-2, 2), slope_y = source.integer(-2, 2);
  for (std::uint32_t r = 0; r < parts.rows; ++r) {
    for (std::uint32_t c = 0; c < parts.columns; ++c) {
      double height = 0;
      if (ground == Ground::Rough) height = source.uniform(-1.5, 1.5);
      if (ground == Ground::Steps) height = source.integer(0, 3);
      if (ground == Ground::Tilted) height = slope_x * c + slope_y * r;
      parts.heights.push_back(static_cast<float>(height));
    }
  }
  const std::size_t cells = std::size_t{parts.columns - 1} * (parts.rows - 1);
  if (source.integer(0, 1) != 0) {
    parts.holes.resize(cells);
    for (std::uint8_t& hole : parts.holes)
      hole = source.integer(0, 5) == 0;
    // So that 0 is triangle 0 in both, as where a contact is of no triangle.
    parts.holes[0] = 0;
  }
  return parts;
}

FieldTwins::FieldTwins(const HeightField& field) : field_(field), mesh_(field.mesh()) {
  for (std::uint32_t r = 0; r + 1 < field.rows(); ++r) {
    for (std::uint32_t c = 0; c + 1 < field.columns(); ++c) {
      if (field.is_hole(c, r)) continue;
      const std::uint32_t first = 2 * (r * (field.columns() - 1) + c);
      numbers_.push_back(first);
      numbers_.push_back(first + 1);
    }
  }
}

Manifold FieldTwins::numbered(Manifold manifold, bool is_mesh_a) const {
  // As TriangleCandidates names them: bits 62 and 63 are edges and corners, by vertices.
  constexpr std::uint64_t kNoFace = std::uint64_t{3} << 62;
  for (std::size_t i = 0; i < manifold.size(); ++i) {
    std::uint64_t& feature = is_mesh_a ? manifold[i].feature.a : manifold[i].feature.b;
    if ((feature & kNoFace) != 0) continue;
    const std::uint64_t triangle = numbers_[feature >> 32];
    feature = triangle << 32 | (feature & 0xffffffff);
  }
  return manifold;
}

Pose pose_near(const FieldTwins& twins, const Pose& field_pose, RandomSource& source) {
  const HeightField& field = twins.value();
  Pose pose = Pose::Identity();
  if (source.integer(0, 2) != 0) pose = random_pose(0, source);
  const auto column =
      static_cast<std::uint32_t>(source.integer(0, static_cast<int>(field.columns()) - 1));
  const auto row =
      static_cast<std::uint32_t>(source.integer(0, static_cast<int>(field.rows()) - 1));
  Vector3d at = field.vertex(column, row);
  if (source.integer(0, 2) != 0) {
    const double spacing_x = field.vertex(1, 0).x(), spacing_y = field.vertex(0, 1).y();
    const bool is_even = source.integer(0, 1) != 0;
    at.x() += spacing_x * (is_even ? source.integer(-1, 1) / 2 : source.uniform(-1, 1));
    at.y() += spacing_y * (is_even ? source.integer(-1, 1) / 2 : source.uniform(-1, 1));
  }
  at.z() += source.integer(0, 1) != 0 ? source.integer(-1, 4) / 4 : source.uniform(-0.5, 1.5);
  pose.translation() = at;
  return field_pose * pose;
}

}  // namespace graze::tests
