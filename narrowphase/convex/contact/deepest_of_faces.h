#pragma once

#include <graze/narrowphase/convex/contact/meeting_points.h>
#include <graze/narrowphase/convex/core/contact_face.h>

#include <optional>

namespace graze::narrowphase {

/// Of two polygons that face each other along a unit normal from A to B: the points of both on the
/// line along it on which A reaches past B farthest. What is a cap of a cylinder or a cone's base
/// counts as the disc that it is. Nothing if no such line meets both, if corners of one are too
/// sharp or too uneven to say, or if rims that cross are not found to.
/// Of two polygons O(n m) for n and m corners, with a disc O(n), of two discs O(1).
std::optional<MeetingPoints> deepest_of_faces(const FaceOf& a, const FaceOf& b, const Vec3& normal);

/// Whether nothing beside these faces is deeper than they are: rounded edges may be, and faces of a
/// hull that lean from one of its own by little more than the two lean from each other.
bool are_deepest(const FaceOf& a, const FaceOf& b, const Vec3& normal);

}  // namespace graze::narrowphase
