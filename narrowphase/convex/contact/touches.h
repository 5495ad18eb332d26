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
  Vec3 point_b;             ///< on B's: depth along the normal before point_a, mostly
  Vec3 normal;              ///< unit, from A to B
  double depth;             ///< metres, >= 0, along the normal at these points
  std::uint64_t feature_a;  ///< which corner, edge or face of A: the same from step to step
  std::uint64_t feature_b;
};

/// Midway between the two boundaries.
static inline Vec3 middle_of(const ContactPoint& touch) {
  return (touch.point_a + touch.point_b) * 0.5;
}

/// Of a point that is of no corner, edge or face in particular.
inline constexpr std::uint64_t kPointFeature = 0x30000;

/// How two sets that touch part soonest, and at what cost.
struct Parting {
  Penetration way;
  bool has_witnesses = false;  ///< whether the way's points are where the two meet
  bool is_asked = false;       ///< whether penetration() was
  bool is_failed = false;      ///< and did not prove its depth to be the least
};

/// For sets whose cores have this gap. Rounded parts: along the way between the cores. Two boxes,
/// and a point in a box, by their faces; all others by penetration(), and then by the faces at hand
/// if one is as good.
Parting part(const Core& a, const Core& b, const CoreGap& gap);
Parting part_boxes(const BoxAxes& boxes);

/// The points of contact along that way, added to `touches`; one at least. Where faces face each
/// other along the normal, the one is clipped by the other's sides, else there is one point.
void add_touches(const Core& a, const Core& b, const Parting& parting,
                 std::vector<ContactPoint>& touches);

/// Of these, only those where faces face each other: none, if none do.
void add_face_touches(const Core& a, const Core& b, const Penetration& way,
                      std::vector<ContactPoint>& touches);

/// Leaves at most `most` of the touches, the deepest first: the deepest, to 1e-5 of their spread,
/// and those that are far from all that are left. Ties, of depths to that and of distances to 1e-4,
/// go to the lower features.
void reduce(std::vector<ContactPoint>& touches, std::size_t most);

}  // namespace graze::narrowphase
