#include <graze/engine/compare/judge/bodies/least_parting.h>
#include <graze/engine/compare/judge/bodies/shape_bodies.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace graze::compare {
namespace {

using Eigen::Vector3d;

/// So many triangles of directions are divided: for shapes that are about as wide wherever one
/// turns no number is enough. For many corners fewer are.
constexpr std::size_t kMostDivisions = std::size_t{1} << 14;
constexpr std::size_t kMostCorners = std::size_t{1} << 22;  // the number of corners that are looked
                                                            // through for these
constexpr std::size_t kLeastDivisions = 64;

/// Finds a point of the shape, without its radius, that is as far along d as any, in the shape's
/// frame.
struct FarPoint {
  const Vector3d& d;

  double sign(int axis) const { return d[axis] < 0 ? -1 : 1; }
  Vector3d on_circle(double radius, double height) const {
    const double flat = std::hypot(d.x(), d.y());
    if (flat == 0) return {radius, 0, height};
    return {radius * (d.x() / flat), radius * (d.y() / flat), height};
  }

  Vector3d operator()(const Sphere& s) const { return s.centre; }
  Vector3d operator()(const Box& s) const {
    return {sign(0) * s.half_extents.x(), sign(1) * s.half_extents.y(),
            sign(2) * s.half_extents.z()};
  }
  Vector3d operator()(const Capsule& s) const { return {0, 0, sign(2) * s.half_length}; }
  Vector3d operator()(const Cylinder& s) const {
    return on_circle(s.radius, sign(2) * s.half_height);
  }
  Vector3d operator()(const Cone& s) const {
    const Vector3d apex(0, 0, s.half_height);
    const Vector3d rim = on_circle(s.radius, -s.half_height);
    return d.dot(apex) > d.dot(rim) ? apex : rim;
  }
  Vector3d operator()(const Ellipsoid& s) const {
    const Vector3d stretched = d.cwiseProduct(s.semi_axes);
    return s.centre + s.semi_axes.cwiseProduct(stretched) / stretched.norm();
  }
  Vector3d operator()(const ConvexHull& s) const {
    return farthest(s.vertex_count(), [&](std::size_t i) { return s.vertex(i); });
  }
  Vector3d operator()(const Mesh& s) const {
    return farthest(s.vertices().size(), [&](std::size_t i) { return s.vertices()[i]; });
  }
  Vector3d operator()(const HeightField& s) const { return (*this)(s.mesh()); }
  Vector3d operator()(const HalfSpace&) const { return Vector3d::Zero(); }  // see out_of_flat()
  Vector3d operator()(const Plane&) const { return Vector3d::Zero(); }

  template <typename VertexOf>
  Vector3d farthest(std::size_t count, const VertexOf& vertex_of) const {
    std::size_t best = 0;
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; ++i) {
      const double along = d.dot(vertex_of(i));
      if (along > most) best = i;
      most = std::max(most, along);
    }
    return vertex_of(best);
  }
};

std::size_t corner_count(const Shape& shape) {
  if (const auto* hull = shape.as<ConvexHull>()) return hull->vertex_count();
  if (const auto* mesh = shape.as<Mesh>()) return mesh->vertices().size();
  if (const auto* field = shape.as<HeightField>()) return field->mesh().vertices().size();
  return 1;
}

double radius_of(const Shape& shape) {
  if (const auto* ball = shape.as<Sphere>()) return ball->radius;
  if (const auto* capsule = shape.as<Capsule>()) return capsule->radius;
  return 0;
}

Vector3d far_point(const PlacedBody& body, const Vector3d& n) {
  const Vector3d d = body.pose.linear().transpose() * n;
  return body.pose * std::visit(FarPoint{d}, body.shape.value());
}

/// Holds a direction and what is as far along it as any point of the difference.
struct Look {
  Vector3d n;
  Vector3d point;
  double length() const { return n.dot(point); }
};

/// Holds directions that are positive sums of three, or in a plane of two.
template <std::size_t N>
struct Patch {
  std::array<Look, N> corners;
  double bound;  ///< no direction of it has a shorter translation
};

/// Returns the flatness f of three corners: a unit vector is a sum of them whose weights add up to
/// one or more, and to no more than 1 / f.
double flatness(const std::array<Look, 3>& corners) {
  const Vector3d& u = corners[0].n;
  const Vector3d across = (corners[1].n - u).cross(corners[2].n - u);
  return std::abs(across.dot(u)) / across.norm();
}
double flatness(const std::array<Look, 2>& corners) {
  return (corners[0].n + corners[1].n).norm() / 2;
}

/// Searches directions: N is 3 for all of them, and 2 for those of a half-plane.
template <std::size_t N>
class Search {
 public:
  Search(const PlacedBody& a, const PlacedBody& b) : a_(a), b_(b) {}

  Look look(const Vector3d& n) {
    Look seen{n, far_point(a_, n) - far_point(b_, -n)};
    if (best_.n.isZero() || seen.length() < best_.length()) best_ = seen;
    return seen;
  }

  /// Adds a patch, all of whose directions are to be looked through.
  void add(const std::array<Look, N>& corners) {
    add(corners, -std::numeric_limits<double>::infinity());
  }

  LeastParting run(double tolerance) {
    const std::size_t corners = corner_count(a_.shape) + corner_count(b_.shape);
    const std::size_t most = std::clamp(kMostCorners / corners, kLeastDivisions, kMostDivisions);
    for (std::size_t i = 0; i < most && patches_.front().bound < best_.length() - tolerance; ++i)
      divide_first();
    return {std::min(patches_.front().bound, best_.length()), best_.length(), best_.n};
  }

 private:
  static bool is_later(const Patch<N>& p, const Patch<N>& q) { return p.bound > q.bound; }

  /// Adds a patch: what holds for all of it holds for its parts.
  void add(const std::array<Look, N>& corners, double bound_of_all) {
    const double flat = flatness(corners);
    double bound = bound_of_all;
    Vector3d sum = Vector3d::Zero();
    for (const Look& corner : corners)
      sum += corner.n;
    const auto better_by = [&](const Look& each) {
      double least = std::numeric_limits<double>::infinity();
      for (const Look& corner : corners)
        least = std::min(least, each.point.dot(corner.n));
      bound = std::max(bound, least < 0 ? least / flat : least);
    };
    for (const Look& corner : corners)
      better_by(corner);
    better_by(look(sum.normalized()));
    patches_.push_back({corners, bound});
    std::push_heap(patches_.begin(), patches_.end(), is_later);
  }

  void divide_first() {
    std::pop_heap(patches_.begin(), patches_.end(), is_later);
    const Patch<N> patch = patches_.back();
    patches_.pop_back();
    if constexpr (N == 2) {
      const Look middle = look((patch.corners[0].n + patch.corners[1].n).normalized());
      add({patch.corners[0], middle}, patch.bound);
      add({middle, patch.corners[1]}, patch.bound);
    } else {
      std::array<Look, 3> between;
      for (std::size_t i = 0; i < 3; ++i)
        between[i] = look((patch.corners[i].n + patch.corners[(i + 1) % 3].n).normalized());
      for (std::size_t i = 0; i < 3; ++i)
        add({patch.corners[i], between[i], between[(i + 2) % 3]}, patch.bound);
      add(between, patch.bound);
    }
  }

  PlacedBody a_;
  PlacedBody b_;
  Look best_{Vector3d::Zero(), Vector3d::Zero()};
  std::vector<Patch<N>> patches_;  ///< a heap: the least bound first
};

LeastParting over_all_directions(const PlacedBody& a, const PlacedBody& b, const Vector3d& proposed,
                                 double tolerance) {
  Search<3> search(a, b);
  search.look(proposed.normalized());
  for (const PlacedBody* body : {&a, &b}) {
    for (int axis = 0; axis < 3; ++axis) {
      search.look(body->pose.linear().col(axis).normalized());
      search.look(-body->pose.linear().col(axis).normalized());
    }
  }
  for (int octant = 0; octant < 8; ++octant) {
    std::array<Look, 3> corners;
    for (int axis = 0; axis < 3; ++axis) {
      const double side = (octant >> axis & 1) == 0 ? 1 : -1;
      corners[static_cast<std::size_t>(axis)] = search.look(side * Vector3d::Unit(axis));
    }
    search.add(corners);
  }
  return search.run(tolerance);
}

/// Holds a shape that may turn about a line, in the frame of the world.
struct RoundBody {
  Vector3d middle;               ///< a point on the line
  std::optional<Vector3d> axis;  ///< unit; without one it may turn about any line through its
                                 ///< middle
  double bounding_radius;        ///< no point of it is farther from the middle
};

/// Returns the shape without its radius, as far_point() has it.
std::optional<RoundBody> round_body(const PlacedBody& body) {
  const auto about_z = [&](double bounding_radius) {
    return RoundBody{body.pose.translation(), body.pose.linear().col(2).normalized(),
                     bounding_radius};
  };
  if (const auto* s = body.shape.as<Sphere>()) return RoundBody{body.pose * s->centre, {}, 0};
  if (const auto* s = body.shape.as<Capsule>()) return about_z(s->half_length);
  if (const auto* s = body.shape.as<Cylinder>())
    return about_z(std::hypot(s->radius, s->half_height));
  if (const auto* s = body.shape.as<Cone>()) return about_z(std::hypot(s->radius, s->half_height));
  const auto* s = body.shape.as<Ellipsoid>();
  if (s == nullptr) return std::nullopt;
  RoundBody found{body.pose * s->centre, {}, s->semi_axes.maxCoeff()};
  for (int axis = 0; axis < 3; ++axis) {
    if (s->semi_axes[(axis + 1) % 3] != s->semi_axes[(axis + 2) % 3]) continue;
    if (s->semi_axes[axis] == s->semi_axes[(axis + 1) % 3]) return found;
    found.axis = body.pose.linear().col(axis).normalized();
    return found;
  }
  return std::nullopt;
}

/// Holds the line about which two shapes may turn, and how far a point of B must move until that is
/// exactly so.
struct CommonAxis {
  Vector3d along;
  double off;
};

std::optional<CommonAxis> common_axis(const PlacedBody& a, const PlacedBody& b) {
  const std::optional<RoundBody> round_a = round_body(a), round_b = round_body(b);
  if (!round_a || !round_b) return std::nullopt;
  const Vector3d between = round_b->middle - round_a->middle;
  if (!round_a->axis && !round_b->axis)
    return CommonAxis{between.isZero() ? Vector3d::UnitX() : between.normalized(), 0};
  const Vector3d along = round_a->axis ? *round_a->axis : *round_b->axis;
  double off = between.cross(along).norm();
  if (round_b->axis) off += 2 * round_b->bounding_radius * round_b->axis->cross(along).norm();
  return CommonAxis{along, off};
}

/// Finds the bounds for shapes that are the same all around a line, so that the directions of a
/// half-plane are enough. The bound is lower by what a shape is off the line, once for these
/// directions and once for all others.
LeastParting over_half_plane(const PlacedBody& a, const PlacedBody& b, const CommonAxis& axis,
                             double tolerance) {
  Search<2> search(a, b);
  const Look out = search.look(axis.along), aside = search.look(axis.along.unitOrthogonal()),
             back = search.look(-axis.along);
  search.add({out, aside});
  search.add({aside, back});
  LeastParting found = search.run(tolerance);
  found.least -= 2 * axis.off;
  return found;
}

/// Leads B out of a half-space along its normal, and out of a plane along that or the other way.
LeastParting out_of_flat(const PlacedBody& flat, const PlacedBody& other) {
  const Vector3d n = flat.pose.linear() * flat_of(flat.shape)->normal;
  const auto length = [&](const Vector3d& out) {
    return support_along(flat.shape, flat.pose, out) + support_along(other.shape, other.pose, -out);
  };
  LeastParting found{length(n), length(n), n};
  if (flat.shape.kind() == ShapeKind::Plane && length(-n) < found.most)
    found = {length(-n), length(-n), -n};
  return found;
}

}  // namespace

std::optional<LeastParting> least_parting(const PlacedBody& a, const PlacedBody& b,
                                          const Vector3d& proposed, double tolerance) {
  if (flat_of(a.shape) && flat_of(b.shape)) return std::nullopt;
  if (flat_of(a.shape)) return out_of_flat(a, b);
  if (flat_of(b.shape)) {
    LeastParting found = out_of_flat(b, a);
    found.direction = -found.direction;
    return found;
  }
  const bool has_direction = proposed.squaredNorm() > 0 && proposed.allFinite();
  const std::optional<CommonAxis> axis = common_axis(a, b);
  LeastParting found =
      axis && axis->off <= tolerance / 4
          ? over_half_plane(a, b, *axis, tolerance / 2)
          : over_all_directions(a, b, has_direction ? proposed : Vector3d::UnitX(), tolerance);
  const double radii = radius_of(a.shape) + radius_of(b.shape);
  found.least += radii;
  found.most += radii;
  return found;
}

}  // namespace graze::compare
