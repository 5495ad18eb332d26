#pragma once

// The pair functions: what each row of the table of pairs answers. A's kind is not above B's.
// Private to engine/world.

#include <graze/engine/world/shapes/pair_input.h>
#include <graze/narrowphase/triangle.h>

namespace graze {

/// Two boxes, along 15 axes, and by their cores where rounding may hide a gap along a product of
/// edges that are nearly parallel.
bool intersect_boxes(const PlacedShapeView& a, const PlacedShapeView& b, Work& work);

bool intersect_cores(const PlacedShapeView& a, const PlacedShapeView& b, Work& work);
ShapeDistance distance_of_cores(const PlacedShapeView& a, const PlacedShapeView& b, Work& work);

/// Where a test of its own says whether the two touch: two spheres, a sphere and a box, two boxes.
/// What it finds apart has a distance above 0, and as right a one as the kinds allow.
ShapeDistance distance_of_spheres(const PlacedShapeView& a, const PlacedShapeView& b, bool is_hit,
                                  Work& work);
ShapeDistance distance_of_sphere_and_box(const PlacedShapeView& a, const PlacedShapeView& b,
                                         bool is_hit, Work& work);
ShapeDistance distance_of_boxes(const PlacedShapeView& a, const PlacedShapeView& b, bool is_hit,
                                Work& work);

/// Of a ball and a triangle of a mesh, relative to the ball's middle: apart exactly if the test of
/// the two says so. The distance is as right as it is small, and so is its bound.
SetGap gap_of_ball(const Sphere& placed, const Triangle& triangle);

/// As a test says that is more exact than the distance's own rounding.
ShapeDistance agreeing(ShapeDistance found, bool is_hit);

/// B is the half-space.
bool intersect_plane(const PlacedShapeView& a, const PlacedShapeView& b);
ShapeDistance distance_to_plane(const PlacedShapeView& a, const PlacedShapeView& b);
bool intersect_planes(const PlacedShapeView& a, const PlacedShapeView& b);
ShapeDistance distance_of_planes(const PlacedShapeView& a, const PlacedShapeView& b);

/// B is the mesh; A a half-space, or a convex shape.
bool intersect_mesh_plane(const PlacedShapeView& a, const PlacedShapeView& b, Work& work);
ShapeDistance distance_of_mesh_plane(const PlacedShapeView& a, const PlacedShapeView& b,
                                     Work& work);
bool intersect_mesh_core(const PlacedShapeView& a, const PlacedShapeView& b, Work& work);
ShapeDistance distance_of_mesh_core(const PlacedShapeView& a, const PlacedShapeView& b, Work& work);
/// Of a sphere or a box and a mesh, where the exact test has said whether they touch.
ShapeDistance distance_of_mesh_volume(const PlacedShapeView& a, const PlacedShapeView& b,
                                      bool is_hit, Work& work);

}  // namespace graze
