#pragma once

#include <graze/narrowphase/convex/contact/meeting_points.h>
#include <graze/narrowphase/convex/core/contact_face.h>

#include <optional>

namespace graze::narrowphase {

/// Takes two polygons that face each other along a unit normal from A to B, finds the line along it
/// on which A reaches past B farthest, and returns the points of both there. A cap of a cylinder,
/// or a cone's base, counts as the disc that it is. Returns nothing if no such line meets both, if
/// corners of one are too sharp or too uneven to say, or if rims that cross are not found to. Takes
/// O(n m) for two polygons of n and m corners, O(n) for one and a disc, O(1) for two discs.
std::optional<MeetingPoints> deepest_of_faces(const FaceOf& a, const FaceOf& b, const Vec3& normal);

/// True if nothing beside these faces is deeper than they are. Rounded edges may be, and so may
/// faces of a hull that lean from one of its own by little more than the two lean from each other.
bool are_deepest(const FaceOf& a, const FaceOf& b, const Vec3& normal);

}  // namespace graze::narrowphase
