#include <graze/narrowphase/convex/core/contact_face.h>
#include <graze/narrowphase/convex/core/hull.h>

#include <algorithm>

namespace graze::narrowphase {
namespace {

constexpr int kRimCorners = 8;
constexpr double kDiagonal = 0.70710678118654752;  // sqrt(1/2)
constexpr double kRim[kRimCorners][2] = {
    {1, 0},  {kDiagonal, kDiagonal},   {0, 1},  {-kDiagonal, kDiagonal},
    {-1, 0}, {-kDiagonal, -kDiagonal}, {0, -1}, {kDiagonal, -kDiagonal}};

void add(ContactFace& face, const Core& core, const Vec3& own, std::uint32_t id) {
  face.corner[face.count] = core.at + turned(core, own);
  face.corner_id[face.count++] = id;
}

void set_normal(ContactFace& face, const Core& core, const Vec3& own) {
  face.normal = unit_or(turned(core, own), {0, 0, 1});
}

ContactFace point_along(const Core& core, const Vec3& direction) {
  ContactFace face;
  face.corner[0] = rounded_support(core, direction);
  face.corner_id[0] = 0;
  face.count = 1;
  face.normal = direction;
  return face;
}

/// Returns a face of a box. Corner i of a box has bit k of i set where its coordinate k is
/// positive.
ContactFace box_face(const Core& core, const Vec3& own) {
  const double along[3] = {own.x, own.y, own.z};
  const double half[3] = {core.half.x, core.half.y, core.half.z};
  int k = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(along[i]) > std::abs(along[k])) k = i;
  }
  const bool is_positive = along[k] >= 0;
  const int u = (k + 1) % 3, v = (k + 2) % 3;
  ContactFace face;
  face.id = static_cast<std::uint32_t>(2 * k + (is_positive ? 1 : 0));
  const Vec3 out = core.axis[k] * (is_positive ? half[k] : -half[k]);
  const Vec3 middle = core.at + out, side_u = core.axis[u] * half[u],
             side_v = core.axis[v] * half[v];
  constexpr int kTurn[4][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  for (int i = 0; i < 4; ++i) {
    const int* turn = kTurn[is_positive ? i : 3 - i];
    face.corner[i] =
        (turn[0] > 0 ? middle + side_u : middle - side_u) + (turn[1] > 0 ? side_v : -side_v);
    face.corner_id[i] =
        (is_positive ? 1u << k : 0u) | (turn[0] > 0 ? 1u << u : 0u) | (turn[1] > 0 ? 1u << v : 0u);
  }
  face.count = 4;
  face.normal = unit_or(is_positive ? core.axis[k] : -core.axis[k], {0, 0, 1});
  return face;
}

/// Returns a cap: face 0 is the cap at +z, 1 that at -z.
ContactFace cap(const Core& core, bool is_upper) {
  ContactFace face;
  face.id = is_upper ? 0 : 1;
  const double z = is_upper ? core.half.z : -core.half.z;
  for (int i = 0; i < kRimCorners; ++i) {
    const int corner = is_upper ? i : kRimCorners - 1 - i;
    add(face, core, {core.half.x * kRim[corner][0], core.half.x * kRim[corner][1], z},
        static_cast<std::uint32_t>(corner + (is_upper ? 0 : kRimCorners)));
  }
  set_normal(face, core, {0, 0, is_upper ? 1.0 : -1.0});
  return face;
}

/// Returns the segment along the side that faces (x, y), from -z to +z, with the radii there: face
/// 2.
ContactFace side(const Core& core, const Vec3& own, double low_radius, double high_radius) {
  const Vec3 out = unit_or({own.x, own.y, 0}, {1, 0, 0});
  ContactFace face;
  face.id = 2;
  add(face, core, {out.x * low_radius, out.y * low_radius, -core.half.z}, 0);
  add(face, core, {out.x * high_radius, out.y * high_radius, core.half.z}, 1);
  const double rise = 2 * core.half.z;
  set_normal(face, core, {out.x * rise, out.y * rise, low_radius - high_radius});
  return face;
}

ContactFace cylinder_face(const Core& core, const Vec3& own) {
  const double flat = std::sqrt(own.x * own.x + own.y * own.y);
  if (std::abs(own.z) > flat) return cap(core, own.z > 0);
  return side(core, own, core.half.x, core.half.x);
}

ContactFace cone_face(const Core& core, const Vec3& own) {
  const double flat = std::sqrt(own.x * own.x + own.y * own.y);
  const double slant = length(Vec3{core.half.x, 0, 2 * core.half.z});
  const double along_side = (flat * 2 * core.half.z + own.z * core.half.x) / slant;
  if (-own.z > along_side) return cap(core, false);
  return side(core, own, core.half.x, 0);
}

/// Returns the side of a capsule while its ends face the direction less than at 45 degrees.
ContactFace segment_face(const Core& core, const Vec3& direction, const Vec3& own) {
  const double flat = std::sqrt(own.x * own.x + own.y * own.y);
  if (std::abs(own.z) > flat) {
    ContactFace face = point_along(core, direction);
    face.id = own.z > 0 ? 1 : 0;
    return face;
  }
  return side(core, own, 0, 0);
}

ContactFace hull_face(const Core& core, const Vec3& own) {
  const Hull& hull = *core.hull;
  std::size_t best = 0;
  double most = -2, next = -2;
  for (std::size_t i = 0; i < hull.contact_faces.size(); ++i) {
    const double along = dot(hull.contact_faces[i].normal, own);
    next = std::max(next, std::min(along, most));
    if (along > most) best = i, most = along;
  }
  const Hull::Face& found = hull.contact_faces[best];
  ContactFace face;
  face.id = static_cast<std::uint32_t>(best);
  constexpr std::uint32_t kMost = ContactFace::kMostCorners;
  const std::uint32_t count = found.count < kMost ? found.count : kMost;
  face.next_facing = count < found.count ? 1 : next;
  // Corners that are within an edge of the polygon, as seen along the normal, are none of its own,
  // and may still be the ones in front.
  const double highest = hull.contact_offsets[best];
  double lowest = highest;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t corner = hull.contact_loops[found.first + i * found.count / count];
    add(face, core, hull.corners[corner], corner);
    lowest = std::min(lowest, dot(found.normal, hull.corners[corner]));
  }
  face.unevenness = highest - lowest;
  set_normal(face, core, found.normal);
  return face;
}

/// Returns a face of a triangle, of which both sides are one: 0 is the side on which it turns
/// counter-clockwise.
ContactFace triangle_face(const Core& core, const Vec3& direction) {
  const Vec3 normal = cross(core.corner[1] - core.corner[0], core.corner[2] - core.corner[0]);
  const bool is_front = dot(normal, direction) >= 0;
  ContactFace face;
  face.id = is_front ? 0 : 1;
  face.count = 3;
  for (std::uint32_t i = 0; i < 3; ++i) {
    face.corner_id[i] = is_front ? i : 2 - i;
    face.corner[i] = core.corner[face.corner_id[i]];
  }
  face.normal = unit_or(is_front ? normal : -normal, direction);
  return face;
}

ContactFace face_of_core(const Core& core, const Vec3& unit_direction) {
  const Vec3 own = into_own(core, unit_direction);
  switch (core.kind) {
    case CoreKind::Box:
      return box_face(core, own);
    case CoreKind::Segment:
      return segment_face(core, unit_direction, own);
    case CoreKind::Cylinder:
      return cylinder_face(core, own);
    case CoreKind::Cone:
      return cone_face(core, own);
    case CoreKind::Points:
      return core.hull != nullptr ? hull_face(core, own) : point_along(core, unit_direction);
    case CoreKind::Triangle:
      return triangle_face(core, unit_direction);
    default:
      return point_along(core, unit_direction);
  }
}

}  // namespace

ContactFace face_along(const Core& core, const Vec3& unit_direction) {
  ContactFace face = face_of_core(core, unit_direction);
  if (face.count > 1 && core.radius > 0) {  // points have it already
    for (int i = 0; i < face.count; ++i)
      face.corner[i] = face.corner[i] + face.normal * core.radius;
  }
  return face;
}

}  // namespace graze::narrowphase
