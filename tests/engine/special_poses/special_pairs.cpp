#include "tests/engine/special_poses/special_pairs.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/shape_kinds.h"

namespace graze::tests {

using Eigen::Vector3d;

namespace {

ConvexHull plain_hull(std::size_t index, double x, double y, double z) {
  std::vector<Vector3d> corners;
  for (int i = 0; i < 8; ++i) {
    const Vector3d sign(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    const bool is_of_tetrahedron = sign.prod() > 0;
    if (index % 3 == 0 || (index % 3 == 1 && is_of_tetrahedron)) {
      corners.emplace_back(sign.cwiseProduct(Vector3d(x, y, z)));
    }
  }
  if (index % 3 == 2) {
    for (const double sign : {-1.0, 1.0}) {
      corners.emplace_back(sign * x, 0, 0);
      corners.emplace_back(0, sign * y, 0);
      corners.emplace_back(0, 0, sign * z);
    }
  }
  return ConvexHull(corners);
}

void move_to_touch(PlacedPair& pair, const Vector3d& axis) {
  for (int repeated = 0; repeated < 2; ++repeated)
    pair.pose_b.translation() += axis * width_along(pair, axis);
}

Pose about_origin(const Pose& pose, const Eigen::Matrix3d& turn) {
  Pose turned = pose;
  turned.linear() = turn * pose.linear();
  turned.translation() = turn * pose.translation();
  return turned;
}

double small(RandomSource& source) {
  return std::pow(10.0, source.uniform(-16, -3));
}

}  // namespace

Eigen::Matrix3d right_turn(std::size_t index) {
  constexpr int kOrder[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  const std::size_t order = index / 4 % 6;
  const double s = index & 1 ? -1 : 1;
  const double t = index & 2 ? -1 : 1;
  const double parity = order < 3 ? 1 : -1;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
  turn(kOrder[order][0], 0) = s;
  turn(kOrder[order][1], 1) = t;
  turn(kOrder[order][2], 2) = parity * s * t;
  return turn;
}

Shape plain_shape(ShapeKind kind, std::size_t index) {
  constexpr double kLengths[7][3] = {{1, 1, 1},     {1, 0.5, 0.25}, {0.5, 1, 0.75}, {0.25, 0.5, 1},
                                     {1, 1, 0.125}, {0.5, 0.5, 1},  {0.9, 0.7, 0.3}};
  const auto& [x, y, z] = kLengths[index % 7];
  switch (kind) {
    case ShapeKind::Sphere:
      return Sphere{{0, 0, 0}, x};
    case ShapeKind::Box:
      return Box{{x, y, z}};
    case ShapeKind::Capsule:
      return Capsule{x, z};
    case ShapeKind::Cylinder:
      return Cylinder{x, z};
    case ShapeKind::Cone:
      return Cone{x, z};
    case ShapeKind::Ellipsoid:
      return Ellipsoid{{0, 0, 0}, {x, y, z}};
    case ShapeKind::ConvexHull:
      return plain_hull(index, x, y, z);
    case ShapeKind::HalfSpace:
      return HalfSpace{{0, 0, 1}, 0};
    default:
      return make_box({x, y, z});
  }
}

PlacedPair special_pair(ShapeKind kind_a, ShapeKind kind_b, std::size_t turn, SpecialPlace place,
                        std::size_t index) {
  PlacedPair pair{plain_shape(kind_a, index / 7), plain_shape(kind_b, index), Pose::Identity(),
                  Pose::Identity()};
  pair.pose_b.linear() = right_turn(turn);
  Vector3d axis = Vector3d::Unit(static_cast<int>(index % 3)) * (index % 2 == 0 ? 1.0 : -1.0);
  // Beside a half-space there is one way out.
  if (kind_b == ShapeKind::HalfSpace) axis = -pair.pose_b.linear().col(2);
  if (kind_a == ShapeKind::HalfSpace) axis = pair.pose_a.linear().col(2);
  if (place == SpecialPlace::Offset) {
    constexpr double kShares[] = {0.25, 0.5, 1.0, 0.1, 1e-3};
    pair.pose_b.translation() = axis * (kShares[index % 5] * smaller_size(pair));
  }
  if (place == SpecialPlace::Touching) move_to_touch(pair, axis);
  return pair;
}

PlacedPair scaled(const PlacedPair& pair, double factor) {
  const auto times = [&](const Shape& shape) -> Shape {
    if (const auto* s = shape.as<Sphere>()) return Sphere{s->centre * factor, s->radius * factor};
    if (const auto* s = shape.as<Box>()) return Box{s->half_extents * factor};
    if (const auto* s = shape.as<Capsule>())
      return Capsule{s->radius * factor, s->half_length * factor};
    if (const auto* s = shape.as<Cylinder>())
      return Cylinder{s->radius * factor, s->half_height * factor};
    if (const auto* s = shape.as<Cone>()) return Cone{s->radius * factor, s->half_height * factor};
    if (const auto* s = shape.as<Ellipsoid>())
      return Ellipsoid{s->centre * factor, s->semi_axes * factor};
    if (const auto* s = shape.as<HalfSpace>()) return HalfSpace{s->normal, s->offset * factor};
    if (const auto* s = shape.as<Mesh>()) {
      std::vector<Vector3d> vertices(s->vertices().begin(), s->vertices().end());
      for (Vector3d& vertex : vertices)
        vertex *= factor;
      return Mesh(vertices, std::vector(s->triangles().begin(), s->triangles().end()));
    }
    const auto& hull = *shape.as<ConvexHull>();
    std::vector<Vector3d> corners;
    for (std::size_t i = 0; i < hull.vertex_count(); ++i)
      corners.push_back(hull.vertex(i) * factor);
    return ConvexHull(corners);
  };
  PlacedPair result{times(pair.a), times(pair.b), pair.pose_a, pair.pose_b};
  result.pose_a.translation() *= factor;
  result.pose_b.translation() *= factor;
  return result;
}

PlacedPair drawn_pair(RandomSource& source, std::size_t kinds) {
  const auto any = [&](int count) {
    return static_cast<std::size_t>(source.integer(0, count - 1));
  };
  const ShapeKind kind_a = tests::kOwnKinds[any(static_cast<int>(kinds))];
  ShapeKind kind_b = tests::kOwnKinds[any(static_cast<int>(kinds))];
  if (any(5) == 0) kind_b = kind_a;
  if (kind_a == ShapeKind::HalfSpace && kind_b == kind_a) kind_b = ShapeKind::Mesh;
  PlacedPair pair =
      special_pair(kind_a, kind_b, any(24), static_cast<SpecialPlace>(any(3)), any(49 * 30));
  const std::size_t change = any(10);
  if (any(16) == 0 && kind_a < ShapeKind::HalfSpace) pair.a = random_shape(kind_a, 1, source);
  if (any(16) == 0 && kind_b < ShapeKind::HalfSpace) pair.b = random_shape(kind_b, 1, source);
  if (any(8) == 0 && kind_a != ShapeKind::HalfSpace) pair.b = pair.a;
  if (any(8) == 0) pair.pose_b.translation() += source.vector(-1, 1) * 0.3;
  if (change == 1) pair.pose_b.translation() += source.vector(-1, 1) * small(source);
  if (change == 2 || change == 3) {
    const Eigen::AngleAxisd turn{small(source), source.vector(-1, 1).normalized()};
    pair.pose_b.linear() = turn.toRotationMatrix() * pair.pose_b.linear();
  }
  if (change == 4) {
    const Eigen::AngleAxisd turn(M_PI / 4, Vector3d::Unit(static_cast<int>(any(3))));
    pair.pose_b.linear() = turn.toRotationMatrix() * pair.pose_b.linear();
  }
  if (change == 5) pair.pose_b = pair.pose_a;
  if (change == 6) {
    // Just apart, by next to nothing.
    const LeastWidth least = least_width(pair, 200);
    pair.pose_b.translation() += least.direction * (least.width + small(source));
  }
  if (any(3) == 0) {
    const Eigen::Matrix3d turn = random_pose(1, source).linear();
    pair.pose_a = about_origin(pair.pose_a, turn);
    pair.pose_b = about_origin(pair.pose_b, turn);
  }
  return pair;
}

}  // namespace graze::tests
