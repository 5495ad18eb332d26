#pragma once

// The pair functions, which answer the rows of the table of pairs. A's kind is not above B's.
// Private to engine/world.

#include <graze/engine/world/shapes/pair_input.h>
#include <graze/narrowphase/triangle.h>

namespace graze {

/// Tests two boxes along 15 axes, and their cores where rounding may hide a gap along a product of
/// edges that are nearly parallel.
bool intersect_boxes(const PlacedShapeView& a, const PlacedShapeView& b, Work& work);

bool intersect_cores(const PlacedShapeView& a, const PlacedShapeView& b, Work& work);
ShapeDistance distance_of_cores(const PlacedShapeView& a, const PlacedShapeView& b, Work& work);

/// Return the distance of two spheres, a sphere and a box, or two boxes, for which a separate test
/// has decided whether they touch. If it found them apart, the distance is above 0, and as exact as
/// the kinds allow.
ShapeDistance distance_of_spheres(const PlacedShapeView& a, const PlacedShapeView& b, bool is_hit,
                                  Work& work);
ShapeDistance distance_of_sphere_and_box(const PlacedShapeView& a, const PlacedShapeView& b,
                                         bool is_hit, Work& work);
ShapeDistance distance_of_boxes(const PlacedShapeView& a, const PlacedShapeView& b, bool is_hit,
                                Work& work);

/// Returns the gap of a ball and a triangle of a mesh, relative to the ball's middle: they are
/// apart exactly if their test says so. The distance and its bound have small relative errors.
SetGap gap_of_ball(const Sphere& placed, const Triangle& triangle);

/// Makes a distance agree with a test that is more exact than the distance's own rounding.
ShapeDistance agreeing(ShapeDistance found, bool is_hit);

/// For the next four functions B is a half-space.
bool intersect_plane(const PlacedShapeView& a, const PlacedShapeView& b);
ShapeDistance distance_to_plane(const PlacedShapeView& a, const PlacedShapeView& b);
bool intersect_planes(const PlacedShapeView& a, const PlacedShapeView& b);
ShapeDistance distance_of_planes(const PlacedShapeView& a, const PlacedShapeView& b);

/// For the functions below B is a mesh, and A a half-space or a convex shape.
bool intersect_mesh_plane(const PlacedShapeView& a, const PlacedShapeView& b, Work& work);
ShapeDistance distance_of_mesh_plane(const PlacedShapeView& a, const PlacedShapeView& b,
                                     Work& work);
bool intersect_mesh_core(const PlacedShapeView& a, const PlacedShapeView& b, Work& work);
ShapeDistance distance_of_mesh_core(const PlacedShapeView& a, const PlacedShapeView& b, Work& work);
/// Returns the distance of a sphere or a box and a mesh, for which the exact test has decided
/// whether they touch.
ShapeDistance distance_of_mesh_volume(const PlacedShapeView& a, const PlacedShapeView& b,
                                      bool is_hit, Work& work);

}  // namespace graze
