// A box that does not meet a triangle at t = 0 meets it first with its surface, which is twelve
// triangles with corners that are doubles.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/sweep/earliest_meeting.h>
#include <graze/engine/mesh/sweep/volume_walk.h>
#include <graze/engine/mesh/volume_cast.h>
#include <graze/narrowphase/translation/displacement.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>
#include <graze/narrowphase/triangle_intersection.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <array>
#include <cmath>

namespace graze {
namespace {

constexpr std::uint32_t kFaces = 12;

/// The surface of a box.
struct BoxSurface {
  std::array<Eigen::Vector3d, 8> corner;  ///< bit k of its number says: the larger of coordinate k
  std::array<Triangle, kFaces> triangle;

  explicit BoxSurface(const Aabb& box) {
    for (unsigned i = 0; i < 8; ++i) {
      for (unsigned k = 0; k < 3; ++k)
        corner[i].data()[k] = ((i >> k & 1) != 0 ? box.max : box.min).data()[k];
    }
    std::uint32_t at = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const unsigned own = 1u << axis, next = 1u << (axis + 1) % 3, last = 1u << (axis + 2) % 3;
      for (const unsigned first : {0u, own}) {
        triangle[at++] = {corner[first], corner[first | next], corner[first | next | last]};
        triangle[at++] = {corner[first], corner[first | last], corner[first | next | last]};
      }
    }
  }
};

/// The spans of a box along the directions of a cast: that of all of it, and that of each triangle.
struct BoxSpans {
  contacts::CastDirections::Span all;
  std::array<contacts::CastDirections::Span, kFaces> triangle;

  BoxSpans(const BoxSurface& surface, const contacts::CastDirections& directions) {
    using Side = contacts::CastDirections::Side;
    std::array<const Eigen::Vector3d*, 8> corners;
    for (std::size_t i = 0; i < 8; ++i)
      corners[i] = &surface.corner[i];
    all = directions.of_points(Side::B, corners);
    for (std::uint32_t i = 0; i < kFaces; ++i)
      triangle[i] = directions.of_triangle(Side::B, surface.triangle[i]);
  }
};

/// The box that goes, for VolumeWalk.
class BoxMover {
 public:
  BoxMover(const Aabb& box, const contacts::CastDirections& directions, EarliestMeeting& earliest,
           Work& work)
      : box_(box),
        surface_(box),
        directions_(directions),
        earliest_(earliest),
        work_(work),
        spans_(surface_, directions) {}

  const contacts::CastDirections::Span& span() const { return spans_.all; }
  double limit() const { return earliest_.limit(); }

  bool ask(std::uint32_t index, const Triangle& a, const contacts::CastDirections::Span& span,
           const MeetingBounds& bounds) {
    if (bounds.low <= 0) {
      const narrowphase::Decision decision = narrowphase::decide(a, box_);
      work_.exact_tests += decision.stage == narrowphase::Stage::Exact;
      if (decision.is_hit) {
        earliest_.ask_at_start({index, 0}, a, surface_.triangle[0]);
        return true;
      }
    }
    bool is_first = false;
    for (std::uint32_t k = 0; k < kFaces; ++k) {
      if (directions_.first_contact(span, spans_.triangle[k], bounds.limit) == kNeverMet) continue;
      if (earliest_.ask_later({index, k}, a, surface_.triangle[k])) is_first = true;
    }
    return is_first;
  }

  bool turn(contacts::CastDirections& directions) {
    double normal[3];
    earliest_.rough_normal(normal);
    if (!directions.take_normal(normal)) return false;
    spans_ = BoxSpans(surface_, directions);
    return true;
  }

 private:
  const Aabb& box_;
  BoxSurface surface_;
  const contacts::CastDirections& directions_;
  EarliestMeeting& earliest_;
  Work& work_;
  BoxSpans spans_;
};

bool is_inside(const Eigen::Vector3d& p, const Aabb& box) {
  for (int k = 0; k < 3; ++k) {
    const double x = p.data()[k];
    if (x < box.min.data()[k] || x > box.max.data()[k]) return false;
  }
  return true;
}

/// Returns a point that a triangle shares with the box that it meets: one of its corners, or a
/// point of a face.
Eigen::Vector3d common_point(const Triangle& triangle, const Aabb& box) {
  for (const Eigen::Vector3d* corner : {&triangle.a, &triangle.b, &triangle.c}) {
    if (is_inside(*corner, box)) return *corner;
  }
  for (const Triangle& face : BoxSurface(box).triangle) {
    const TriangleIntersection common = intersection(triangle, face);
    if (common.count > 0) return common.corner[0];
  }
  return triangle.a;
}

/// Casts a box in the frame of the mesh.
std::optional<VolumeCast> cast_box(const contacts::FramedMesh& mesh, const Aabb& box,
                                   const Eigen::Vector3d& displacement,
                                   const contacts::SweepUnits& units, Work& work) {
  const SweepLine line(displacement, units);
  EarliestMeeting earliest(displacement.data(), StartContact::Counts);
  contacts::CastDirections directions(mesh, box, units, line.direction);
  BoxMover mover(box, directions, earliest, work);
  VolumeWalk<BoxMover>(mesh, directions, line, mover, work).run();
  const std::optional<MeshCast> met = earliest.result();
  if (!met) return std::nullopt;
  VolumeCast result{met->time, met->is_at_start, met->pair.a, met->point, met->normal};
  if (met->is_at_start) result.point = common_point(mesh.triangle(met->pair.a), box);
  return result;
}

/// Turns a vector by the rotation of law 3, without its translation.
Eigen::Vector3d turned_into(const Pose& frame, const Eigen::Vector3d& v) {
  const double* m = frame.data();
  Eigen::Vector3d turned;
  for (int i = 0; i < 3; ++i)
    turned.data()[i] =
        (m[4 * i] * v.data()[0] + m[4 * i + 1] * v.data()[1]) + m[4 * i + 2] * v.data()[2];
  return turned;
}

/// Returns a direction of a frame in space, with length 1; zero stays.
Eigen::Vector3d unit_in_space(const Pose& frame, const Eigen::Vector3d& n) {
  const double* m = frame.data();
  double turned[3];
  for (int i = 0; i < 3; ++i)
    turned[i] = (m[i] * n.data()[0] + m[4 + i] * n.data()[1]) + m[8 + i] * n.data()[2];
  const double length =
      std::sqrt((turned[0] * turned[0] + turned[1] * turned[1]) + turned[2] * turned[2]);
  if (length == 0) return n;
  return {turned[0] / length, turned[1] / length, turned[2] / length};
}

void check(const PlacedMeshView& mesh, const Eigen::Vector3d& displacement) {
  check_placement(mesh.pose, mesh.mesh.bounds(), "pose of the mesh");
  narrowphase::check_displacement(displacement);
}

}  // namespace

std::optional<VolumeCast> cast(const PlacedMeshView& mesh, const Aabb& box,
                               const Eigen::Vector3d& displacement, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::optional<VolumeCast> {
    CountedWork counted(work);
    bvh::check_box(box, "box");
    check(mesh, displacement);
    return cast_box({mesh}, box, displacement, contacts::SweepUnits(mesh, box), counted.work());
  });
}

std::optional<VolumeCast> cast(const PlacedMeshView& mesh, const Obb& box,
                               const Eigen::Vector3d& displacement, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::optional<VolumeCast> {
    CountedWork counted(work);
    bvh::check_box(box, "box");
    check(mesh, displacement);
    const Eigen::Vector3d turned = turned_into(box.pose, displacement);
    narrowphase::check_displacement(turned);
    Aabb framed;
    for (int k = 0; k < 3; ++k) {
      framed.min.data()[k] = -box.half_extents.data()[k];
      framed.max.data()[k] = box.half_extents.data()[k];
    }
    std::optional<VolumeCast> met = cast_box({mesh, &box.pose}, framed, turned,
                                             contacts::SweepUnits(mesh, box), counted.work());
    if (!met) return std::nullopt;
    met->point = narrowphase::place(box.pose, met->point);
    met->normal = unit_in_space(box.pose, met->normal);
    return met;
  });
}

}  // namespace graze
