#pragma once

#include <graze/narrowphase/convex/depth/box_axes.h>
#include <graze/narrowphase/convex/depth/penetration.h>
#include <graze/narrowphase/convex/gap/core_gap.h>

#include <cstdint>
#include <vector>

namespace graze::narrowphase {

/// One point of a contact of two sets.
struct ContactPoint {
  Vec3 point_a;             ///< on A's boundary
  Vec3 point_b;             ///< on B's boundary: depth along the normal before point_a, mostly
  Vec3 normal;              ///< unit, from A to B
  double depth;             ///< metres, >= 0, along the normal at these points
  std::uint64_t feature_a;  ///< the corner, edge or face of A: the same from step to step
  std::uint64_t feature_b;
};

/// Returns the point midway between the two boundaries.
static inline Vec3 middle_of(const ContactPoint& contact) {
  return (contact.point_a + contact.point_b) * 0.5;
}

/// The feature of a point that belongs to no corner, edge or face in particular.
inline constexpr std::uint64_t kPointFeature = 0x30000;
/// The feature of the deepest point of two faces, where none of their corners is as deep. Only
/// where faces lean is it a contact of its own; else one of the others moves towards it
/// (reduction.h).
inline constexpr std::uint64_t kDeepestOfFace = 0x30001;

/// Says how two sets that touch part soonest, and at what cost.
struct Parting {
  Penetration penetration;
  bool has_witnesses = false;  ///< true if its points are where the two meet
  bool is_asked = false;       ///< true if penetration() was asked
  bool is_failed = false;      ///< true if penetration() did not prove its depth to be the least
};

/// Finds how two sets whose cores have this gap part. Sets that touch with their rounded parts are
/// moved apart along the line between the nearest points of the cores; two boxes, and a point in a
/// box, by their faces; all others by penetration(), and then by a face next to its normal if that
/// is as good.
Parting part(const Core& a, const Core& b, const CoreGap& gap);
Parting part_boxes(const BoxAxes& boxes);

/// Adds the points of contact for that penetration to `contacts`, at least one. Where faces face
/// each other along the normal, one is clipped by the other's sides, else there is one point.
///
/// With a margin, metres, the two may be apart by as much along the normal, and the depth that is
/// given may be negative. Then A counts as grown: depths are more by the margin, and points of A
/// are moved by it along the normal. So what is moved back is on A's own boundary, however that
/// leans.
void add_contact_points(const Core& a, const Core& b, const Parting& parting,
                        std::vector<ContactPoint>& contacts, double margin = 0);

/// Does the same, but only where faces face each other: adds none where none do.
void add_face_contact_points(const Core& a, const Core& b, const Penetration& penetration,
                             std::vector<ContactPoint>& contacts, double margin = 0);

/// Finds by formula how a box, or a point with a radius, parts soonest from a triangle that it
/// touches: the box by the axes of both, as BoxAxes does, the point by where the triangle is
/// nearest to it. The normal leads to the triangle. The triangle has an area.
Parting part_from_triangle(const Core& core, const Core& triangle);

}  // namespace graze::narrowphase
