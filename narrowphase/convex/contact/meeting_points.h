#pragma once

#include <graze/narrowphase/convex/contact/contact_points.h>
#include <graze/narrowphase/convex/core/contact_face.h>

#include <optional>

namespace graze::narrowphase {

/// Returns the size of the smaller of two sets, by which lengths are measured.
double smaller_size(const Core& a, const Core& b);

/// Holds a point of either surface, where the two meet.
struct MeetingPoints {
  Vec3 on_a;
  Vec3 on_b;
};

/// Returns where two sets meet once B is moved out by a penetration that parts them: points of the
/// surfaces as they lie, so that on_a - on_b is that displacement. It is right to 2^-17 of the
/// smaller size if the depth is the least to kDepthTolerance, and else to as much more as the depth
/// is more.
MeetingPoints meeting_points(const Core& a, const Core& b, const Penetration& penetration);

/// Takes where two sets meet, as a point of either; of the two lines through these along the normal
/// it finds the one on which the sets reach past each other farther, and returns its ends on both.
/// Returns nothing if each of the two lines misses the other set, or no hull is known.
std::optional<MeetingPoints> ends_on_line(const Core& a, const Core& b, const Vec3& normal,
                                          const MeetingPoints& met);

/// True if the points of a penetration, one of each set, lie along its normal. Those of edges that
/// pass each other beyond an end do not.
bool lie_along(const Penetration& penetration, double tolerance);

/// The share of the smaller size by which B is moved out further than the penetration before the
/// nearest points are taken.
inline constexpr double kClearance = 0x1p-20;

/// The vector between the nearest points may be this far aside of the penetration, as a share of
/// the smaller size.
inline constexpr double kMostAside = 0x1p-17;

/// Holds a face that takes part in a contact, and the set whose it is.
struct FaceOf {
  const ContactFace& face;
  const Core& core;
};

/// True if the surface may be off the plane of a face by more than rounding. Only a hull's may be:
/// its faces are made of corners that lie in one plane to kContactFlatness.
bool is_uneven(const FaceOf& of);

/// Returns a point of a face's polygon or its plane moved along `out`, a unit direction within a
/// right angle of the face's normal, to where the set's surface is, if the face is uneven. Returns
/// nothing if the line passes the set by, as it may beside an edge of a needle.
std::optional<Vec3> onto_surface(const FaceOf& of, const Vec3& point, const Vec3& out);

/// True if a point is on a face's polygon or segment, to `within`, metres. It is taken for granted
/// of points of an uneven face, which onto_surface() puts on the surface.
bool lies_on(const FaceOf& of, const Vec3& point, double within);

/// Moves a contact of two round sides, whose lines cross at a small angle, from the line of the
/// incident one towards that of the reference, whose outward sense along the normal is `sign`: to
/// where they are deepest in each other, if they are as round as their radii say. What is no
/// further from the reference's line than `touching`, metres, stays. False if one of the two is not
/// there.
bool move_to_deepest(const FaceOf& incident, const FaceOf& reference, double sign, double touching,
                     ContactPoint& contact);

}  // namespace graze::narrowphase
