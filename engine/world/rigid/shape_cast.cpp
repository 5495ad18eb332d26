#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/traverse/traverse_nearest.h>
#include <graze/engine/mesh/mesh_cast.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/volume_cast.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/rigid/moving_stand_in.h>
#include <graze/engine/world/rigid/straight_advance.h>
#include <graze/engine/world/rigid/swept_core.h>
#include <graze/engine/world/rigid/tree_sweep.h>
#include <graze/engine/world/shape_cast.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shapes/half_space_pair.h>
#include <graze/engine/world/shapes/pair_input.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <graze/narrowphase/translation/displacement.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace graze {
namespace {

using narrowphase::Core;
using narrowphase::Vec3;

constexpr double kNotMet = 2;

Eigen::Vector3d opposite(const Eigen::Vector3d& v) {
  return {-v.x(), -v.y(), -v.z()};
}

/// Returns the answer for A and B from that for B and A along the opposite displacement, in which B
/// rests.
std::optional<ShapeCast> swapped(std::optional<ShapeCast> found,
                                 const Eigen::Vector3d& displacement) {
  if (!found) return found;
  for (int k = 0; k < 3; ++k)
    found->point.data()[k] += found->time * displacement.data()[k];
  found->normal = opposite(found->normal);
  return found;
}

template <typename Cast>
std::optional<ShapeCast> of_exact(const std::optional<Cast>& found) {
  if (!found) return std::nullopt;
  return ShapeCast{found->time, found->is_at_start, found->point, found->normal};
}

/// Returns the contact of shapes that intersect at t = 0.
ShapeCast at_start(const PlacedShapeView& a, const PlacedShapeView& b) {
  ShapeCast cast{0, true, {0, 0, 0}, {0, 0, 1}};
  const bool are_planes =
      a.shape.kind() == ShapeKind::HalfSpace && b.shape.kind() == ShapeKind::HalfSpace;
  const Manifold contacts = are_planes ? Manifold{} : find_contacts(a, b);
  if (contacts.size() == 0) {
    const ShapeDistance found = distance(a, b);
    cast.point = found.point_a;
    cast.normal = found.normal;
    return cast;
  }
  cast.point = contacts[0].point_a;  // the deepest
  cast.normal = contacts[0].normal;
  return cast;
}

/// Casts a mesh, a sphere or a box at a mesh.
std::optional<ShapeCast> cast_at_mesh(const PlacedMeshView& mesh, const PlacedShapeView& b,
                                      const Eigen::Vector3d& displacement, Work& work) {
  if (const auto* sphere = b.shape.as<Sphere>()) {
    const Sphere ball{narrowphase::place(b.pose, sphere->centre), sphere->radius};
    return of_exact(cast(mesh, ball, displacement, {}, &work));
  }
  if (const auto* box = b.shape.as<Box>())
    return of_exact(cast(mesh, Obb{b.pose, box->half_extents}, displacement, &work));
  return of_exact(cast(mesh, PlacedMeshView{*b.shape.as<Mesh>(), b.pose}, displacement, {}, &work));
}

/// Casts beside a plane: the distance of one support point of B, or of A, and the plane changes
/// linearly.
std::optional<ShapeCast> cast_beside_plane(const PlacedShapeView& a, const PlacedShapeView& b,
                                           const Eigen::Vector3d& displacement, Work& work) {
  const ShapeDistance found = distance(a, b, &work);
  const Vec3 normal = to_vec3(found.normal), shift = to_vec3(displacement);
  const double size = length(shift);
  const double rate = 0x1p-48 * size - dot(normal, shift);
  const double gap = found.lower_bound * (1 - 0x1p-50);
  if (!(gap < rate)) return std::nullopt;
  return ShapeCast{gap / rate * (1 - 0x1p-50), false, found.point_a, found.normal};
}

/// Casts two convex shapes, relative to the middle of A.
std::optional<ShapeCast> cast_cores(const PlacedShapeView& a, const PlacedShapeView& b,
                                    const Eigen::Vector3d& displacement, Work& work) {
  const Eigen::Vector3d origin = middle_of(a.shape, a.pose);
  const Core still = core_of(a.shape, a.pose, origin), moving = core_of(b.shape, b.pose, origin);
  const auto met = first_meeting({still, moving, to_vec3(displacement)}, {}, work);
  if (!met) return std::nullopt;
  return ShapeCast{met->time, false, to_eigen(met->point + to_vec3(origin)), to_eigen(met->normal)};
}

double size_of(const Eigen::Vector3d& v) {
  return (std::abs(v.x()) + std::abs(v.y())) + std::abs(v.z());
}

/// Casts a convex shape at a mesh, triangle by triangle.
class CoreToMesh {
 public:
  CoreToMesh(const PlacedMeshView& mesh, const PlacedShapeView& shape,
             const Eigen::Vector3d& displacement, Work& work)
      : origin_(middle_of(shape.shape, shape.pose)),
        core_(core_of(shape.shape, shape.pose, origin_)),
        displacement_(to_vec3(displacement)),
        work_(work),
        descent_(mesh, core_, origin_, work),
        sweep_(descent_, mesh, displacement, room(mesh, displacement)),
        swept_(core_, displacement_, room(mesh, displacement)) {}

  std::optional<ShapeCast> first() {
    bvh::traverse_nearest(descent_.tree(), *this, [&](const bvh::Node& leaf) {
      for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i)
        ask(descent_.tree().primitives[i]);
      return bvh::Walk::Continue;
    });
    if (!best_) return std::nullopt;
    return ShapeCast{best_->time, false, to_eigen(best_->point + to_vec3(origin_)),
                     to_eigen(best_->normal)};
  }

  /// Returns the bound of a node for traverse_nearest(): the first time at which it may be met.
  double of(std::uint32_t node) const {
    ++work_.volume_tests;
    const NearTimes times = sweep_.of_node(node);
    work_.volume_rejections += times.is_never();
    return times.is_never() ? kNotMet : times.first;
  }
  static bool is_missed(double bound) { return bound == kNotMet; }
  bool is_beyond(double bound) const { return best_ && bound > best_->time; }

 private:
  /// Returns more than the tolerance and the rounding of all lengths: shapes that are not so near
  /// are apart.
  double room(const PlacedMeshView& mesh, const Eigen::Vector3d& displacement) const {
    const Aabb& own = mesh.mesh.bounds();
    const double* m = mesh.pose.data();
    const double lengths = size_of(origin_) + size_of({m[12], m[13], m[14]}) + size_of(own.min) +
                           size_of(own.max) + size_of(displacement) + core_.bounding_radius +
                           core_.radius;
    return 8 * kTouchTolerance * lengths;
  }

  void ask(std::uint32_t index) {
    const NearTimes times = sweep_.of_triangle(index);
    if (times.is_never() || is_beyond(times.first)) return;
    const Core triangle = descent_.triangle(index);
    const double until = best_ ? std::min(times.last, best_->time) : times.last;
    if (swept_.is_surely_passed(triangle, until)) return;
    const auto met = first_meeting({triangle, core_, displacement_}, {times.first, until}, work_);
    if (!met || (best_ && met->time >= best_->time)) return;
    best_ = met;
    swept_.take_normal(met->normal);
  }

  Eigen::Vector3d origin_;
  Core core_;
  Vec3 displacement_;
  Work& work_;
  MeshDescent descent_;
  TreeSweep sweep_;
  SweptCore swept_;
  std::optional<StraightMeeting> best_;
};

PlacedMeshView mesh_view(const PlacedShapeView& s) {
  return {*s.shape.as<Mesh>(), s.pose};
}

/// Casts a pair in which B's kind is not below A's, as in the table of pairs, or A is a mesh.
std::optional<ShapeCast> cast_in_order(const PlacedShapeView& a, const PlacedShapeView& b,
                                       const Eigen::Vector3d& displacement, Work& work) {
  const PairMethod method = pair_method(a.shape.kind(), b.shape.kind());
  const bool is_exact = method == PairMethod::MeshVolume || method == PairMethod::Meshes;
  if (is_exact) return cast_at_mesh(mesh_view(a), b, displacement, work);
  if (intersects(a, b, &work)) return at_start(a, b);
  switch (method) {
    case PairMethod::Plane:
    case PairMethod::Planes:
    case PairMethod::MeshPlane:
      return cast_beside_plane(a, b, displacement, work);
    case PairMethod::MeshCore:
      return CoreToMesh(mesh_view(a), b, displacement, work).first();
    default:
      return cast_cores(a, b, displacement, work);
  }
}

/// True if B goes first, so that swapping changes no time: a mesh goes before anything but a mesh.
bool goes_second(const PlacedShapeView& a, const PlacedShapeView& b) {
  const bool is_mesh_a = a.shape.kind() == ShapeKind::Mesh;
  const bool is_mesh_b = b.shape.kind() == ShapeKind::Mesh;
  if (is_mesh_a || is_mesh_b) return is_mesh_b && !is_mesh_a;
  return is_swapped(a, b);
}

void check_coordinates(const PlacedShapeView& shape, const Eigen::Vector3d& displacement) {
  for (int k = 0; k < 3; ++k) {
    const double end = shape.pose.data()[12 + k] + displacement.data()[k];
    if (std::abs(end) <= kLargestLength) continue;
    throw PoseError(std::string("displacement: component ") + "xyz"[k] +
                    " moves a shape too far away");
  }
}

std::optional<ShapeCast> cast_checked(const PlacedShapeView& a, const PlacedShapeView& b,
                                      const Eigen::Vector3d& displacement, Work& work) {
  if (!goes_second(a, b)) return cast_in_order(a, b, displacement, work);
  return swapped(cast_in_order(b, a, opposite(displacement), work), displacement);
}

/// A path beside a height field is looked at in parts, all from its start: the first one is
/// kCellsAtFirst cells long, and each next one kNextPart times as long as the one before.
constexpr double kNextPart = 4;
constexpr double kCellsAtFirst = 32;

double first_part(const PlacedShapeView& a, const PlacedShapeView& b,
                  const Eigen::Vector3d& displacement) {
  double length = 0;
  for (const PlacedShapeView* s : {&a, &b}) {
    if (const auto* field = s->shape.as<HeightField>()) {
      const Aabb& box = field->bounds();
      const double spacing = std::max((box.max.x() - box.min.x()) / field->columns(),
                                      (box.max.y() - box.min.y()) / field->rows());
      length = std::max(length, kCellsAtFirst * spacing);
    }
  }
  const double travel = size_of(displacement);
  return travel > length ? length / travel : 1;
}

/// Casts a pair with one height field, or two: part by part of the path, because a contact in one
/// part hides what is farther.
std::optional<ShapeCast> cast_of_field(const PlacedShapeView& a, const PlacedShapeView& b,
                                       const Eigen::Vector3d& displacement, Work& work) {
  if (intersects(a, b, &work)) {
    const StandIns by(a, b, {.aside = kContactAside});
    return cast_checked(by.a.view(), by.b.view(), displacement, work);
  }
  const auto is_plane = [](const PlacedShapeView& s) {
    return s.shape.kind() == ShapeKind::HalfSpace;
  };
  const auto distance_to = [&](const PlacedShapeView& field, const PlacedShapeView& plane) {
    return nearest_stand_in(field, plane, [&](const Shape& mesh) {
      return distance({mesh, field.pose}, plane, &work).distance;
    });
  };
  if (is_plane(a)) return cast_checked(a, distance_to(b, a).view(), displacement, work);
  if (is_plane(b)) return cast_checked(distance_to(a, b).view(), b, displacement, work);
  for (double until = first_part(a, b, displacement);; until *= kNextPart) {
    until = std::min(until, 1.0);
    const Eigen::Vector3d shift = displacement * until;
    const StandIn of_a = cast_stand_in(a, b, shift), of_b = cast_stand_in(b, a, opposite(shift));
    auto met = cast_checked(of_a.view(), of_b.view(), displacement, work);
    if (until == 1 || (met && met->time < until)) return met;
  }
}

/// Casts a pair with one plane, or two.
std::optional<ShapeCast> cast_of_plane(const PlacedShapeView& a, const PlacedShapeView& b,
                                       const Eigen::Vector3d& displacement, Work& work) {
  const HalfSpacePair by(a, b, work);
  auto met = cast(by.a(), by.b(), displacement, &work);
  if (!by.is_divided()) return met;
  const auto behind = cast(by.a(1), by.b(1), displacement, &work);
  return behind && (!met || behind->time < met->time) ? behind : met;
}

}  // namespace

template <typename>
std::optional<ShapeCast> cast(const PlacedShapeView& shape_a, const PlacedShapeView& shape_b,
                              const Eigen::Vector3d& displacement, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::optional<ShapeCast> {
    check_poses(shape_a.pose, shape_b.pose);
    narrowphase::check_displacement(displacement);
    check_coordinates(shape_b, displacement);
    CountedWork counted(work);
    if (has_plane(shape_a, shape_b))
      return cast_of_plane(shape_a, shape_b, displacement, counted.work());
    return has_field(shape_a, shape_b)
               ? cast_of_field(shape_a, shape_b, displacement, counted.work())
               : cast_checked(shape_a, shape_b, displacement, counted.work());
  });
}
template std::optional<ShapeCast> cast<void>(const PlacedShapeView&, const PlacedShapeView&,
                                             const Eigen::Vector3d&, Work*);

}  // namespace graze
