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

/// Triangles of directions that are divided: of coaxial round shapes, which are as wide whichever
/// way one turns, no number is enough. Of many corners fewer.
constexpr std::size_t kMostDivisions = std::size_t{1} << 14;
constexpr std::size_t kMostCorners = std::size_t{1} << 22;  // that are looked through for these
constexpr std::size_t kLeastDivisions = 64;

/// A point of the shape, without its radius, that is as far along d as any, in the shape's frame.
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

/// A direction and what is as far along it as any point of the difference.
struct Look {
  Vector3d n;
  Vector3d point;
  double way() const { return n.dot(point); }
};

/// Directions that are positive sums of three.
struct Patch {
  std::array<Look, 3> corners;
  double bound;  ///< no direction of it has a shorter way
};

class Search {
 public:
  Search(const PlacedBody& a, const PlacedBody& b) : a_(a), b_(b) {}

  LeastParting run(const Vector3d& proposed, double tolerance) {
    look(proposed.normalized());
    for (const PlacedBody* body : {&a_, &b_}) {
      for (int axis = 0; axis < 3; ++axis) {
        look(body->pose.linear().col(axis).normalized());
        look(-body->pose.linear().col(axis).normalized());
      }
    }
    for (int octant = 0; octant < 8; ++octant) {
      std::array<Look, 3> corners;
      for (int axis = 0; axis < 3; ++axis) {
        const double side = (octant >> axis & 1) == 0 ? 1 : -1;
        corners[static_cast<std::size_t>(axis)] = look(side * Vector3d::Unit(axis));
      }
      add(corners, -std::numeric_limits<double>::infinity());
    }
    const std::size_t corners = corner_count(a_.shape) + corner_count(b_.shape);
    const std::size_t most = std::clamp(kMostCorners / corners, kLeastDivisions, kMostDivisions);
    for (std::size_t i = 0; i < most && patches_.front().bound < best_.way() - tolerance; ++i)
      divide_first();
    return {std::min(patches_.front().bound, best_.way()), best_.way(), best_.n};
  }

 private:
  Look look(const Vector3d& n) {
    Look seen{n, far_point(a_, n) - far_point(b_, -n)};
    if (best_.n.isZero() || seen.way() < best_.way()) best_ = seen;
    return seen;
  }

  static bool is_later(const Patch& p, const Patch& q) { return p.bound > q.bound; }

  /// What holds of all of it holds of its parts.
  void add(const std::array<Look, 3>& corners, double bound_of_all) {
    const Vector3d& u = corners[0].n;
    const Vector3d across = (corners[1].n - u).cross(corners[2].n - u);
    // A unit vector is a sum of the corners whose weights add up to one or more, and to no more
    // than one over this.
    const double flat = std::abs(across.dot(u)) / across.norm();
    double bound = bound_of_all;
    const auto middle = look((u + corners[1].n + corners[2].n).normalized());
    for (const Look* each : {&corners[0], &corners[1], &corners[2], &middle}) {
      double least = std::numeric_limits<double>::infinity();
      for (const Look& corner : corners)
        least = std::min(least, each->point.dot(corner.n));
      bound = std::max(bound, least < 0 ? least / flat : least);
    }
    patches_.push_back({corners, bound});
    std::push_heap(patches_.begin(), patches_.end(), is_later);
  }

  void divide_first() {
    std::pop_heap(patches_.begin(), patches_.end(), is_later);
    const Patch patch = patches_.back();
    patches_.pop_back();
    std::array<Look, 3> between;
    for (std::size_t i = 0; i < 3; ++i)
      between[i] = look((patch.corners[i].n + patch.corners[(i + 1) % 3].n).normalized());
    for (std::size_t i = 0; i < 3; ++i)
      add({patch.corners[i], between[i], between[(i + 2) % 3]}, patch.bound);
    add(between, patch.bound);
  }

  PlacedBody a_;
  PlacedBody b_;
  Look best_{Vector3d::Zero(), Vector3d::Zero()};
  std::vector<Patch> patches_;  ///< a heap: the least bound first
};

/// B leaves a half-space along its normal, and a plane along that or the other way.
LeastParting out_of_flat(const PlacedBody& flat, const PlacedBody& other) {
  const Vector3d n = flat.pose.linear() * flat_of(flat.shape)->normal;
  const auto way = [&](const Vector3d& out) {
    return support_along(flat.shape, flat.pose, out) + support_along(other.shape, other.pose, -out);
  };
  LeastParting found{way(n), way(n), n};
  if (flat.shape.kind() == ShapeKind::Plane && way(-n) < found.most) found = {way(-n), way(-n), -n};
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
  LeastParting found = Search(a, b).run(has_direction ? proposed : Vector3d::UnitX(), tolerance);
  const double radii = radius_of(a.shape) + radius_of(b.shape);
  found.least += radii;
  found.most += radii;
  return found;
}

}  // namespace graze::compare
