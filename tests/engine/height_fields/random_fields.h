#pragma once

// Height fields at random, beside the meshes that they are.

#include <graze/bvh/pose.h>
#include <graze/engine/world/height_field.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "tests/shapes/random_source.h"

namespace graze::tests {

/// What a field was made of.
struct FieldParts {
  std::uint32_t columns = 0, rows = 0;
  std::vector<float> heights;
  std::vector<std::uint8_t> holes, materials;
  HeightFieldSettings settings;  ///< without the lists

  HeightField field() const;
  /// The same heights in 16 bits: they must be whole and below 2^16.
  HeightField short_field() const;
};

enum class Ground : std::uint8_t { Rough, Flat, Steps, Tilted };
inline constexpr int kGrounds = 4;

/// A field of a few metres with holes, in places on a lattice, so that much is coplanar.
FieldParts random_parts(Ground ground, RandomSource& source);

/// A field, and its mesh, of which the numbers of triangles are known.
class FieldTwins {
 public:
  explicit FieldTwins(const HeightField& field);

  const Shape& field() const { return field_; }
  const Shape& mesh() const { return mesh_; }
  const HeightField& value() const { return *field_.as<HeightField>(); }
  /// The field's number of a triangle of the mesh.
  std::uint32_t number(std::uint32_t triangle) const { return numbers_[triangle]; }
  /// Of contacts of the mesh, A or B, those that the field must have.
  Manifold numbered(Manifold manifold, bool is_mesh_a) const;

 private:
  Shape field_, mesh_;
  std::vector<std::uint32_t> numbers_;
};

/// Where a shape of about unit size is near the surface of the field: above or in it, over a
/// vertex, an edge, a hole or a border, in an even pose or a turned one.
Pose pose_near(const FieldTwins& twins, const Pose& field_pose, RandomSource& source);

}  // namespace graze::tests
