#pragma once

#include <graze/narrowphase/triangle.h>

namespace graze::narrowphase {

/// Takes triangles with triangle_a.a == triangle_b.a. True if and only if they share a point
/// besides that vertex, exactly. Degenerate triangles are what they are.
bool intersect_beyond_vertex(const Triangle& triangle_a, const Triangle& triangle_b);

/// Takes triangles with triangle_a.a == triangle_b.a and triangle_a.b == triangle_b.b, two
/// different points. True if and only if they share a point besides the edge between these,
/// exactly.
bool intersect_beyond_edge(const Triangle& triangle_a, const Triangle& triangle_b);

/// True if and only if the triangle is a segment or a point, exactly.
bool is_degenerate(const Triangle& triangle);

}  // namespace graze::narrowphase
