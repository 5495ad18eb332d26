#pragma once

// These do what check_box() and the like do, for functions that run in in_standard_arithmetic()
// already: to read the control word again for each of their arguments would take longer than to
// compare a few numbers.

#include <graze/bvh/aabb.h>
#include <graze/bvh/kdop.h>
#include <graze/bvh/obb.h>
#include <graze/bvh/pose.h>
#include <graze/bvh/sphere.h>

namespace graze::bvh {

void check_box(const Aabb& box, const char* what);
double check_box(const Obb& box, const char* what);  ///< returns what check_rigid() does
void check_sphere(const Sphere& sphere, const char* what);
void check_kdop(const KDop<18>& kdop, const char* what);
double check_rigid(const Pose& pose, const char* what);

}  // namespace graze::bvh
