#pragma once

#include <optional>
#include <span>
#include <vector>

#include <graze/bvh/pose.h>
#include <graze/engine/compare/judge/shrink/reductions.h>
#include <graze/engine/world/shape.h>

namespace graze::compare {

/// Returns all numbers that a file would hold of the shape, in a fixed order.
std::vector<double> numbers_of(const Shape& shape);

/// Returns a shape of the same kind with other numbers. Throws InputError as the shape's
/// constructor does.
Shape with_numbers(const Shape& shape, std::span<const double> numbers);

/// Returns how many triangles a mesh and corners a hull has; 0 for other shapes.
std::size_t part_count(const Shape& shape);

/// Return the mesh or the hull with these parts alone. Throw InputError for a hull without volume.
Shape with_parts(const Shape& shape, const Indices& parts);
Mesh part_of(const Mesh& mesh, const Indices& triangles);

/// Returns the shape with its pose put into its numbers, by law 1; nothing for shapes that need a
/// pose.
std::optional<Shape> unplaced(const Shape& shape, const Pose& pose);

}  // namespace graze::compare
