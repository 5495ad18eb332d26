// Answers the questions that a world asks of a Shape, by the table of all pairs.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/world/body.h>
#include <graze/engine/world/body_shapes/parts_body.h>
#include <graze/engine/world/body_shapes/users_shape.h>
#include <graze/engine/world/contacts/margin/nearness.h>
#include <graze/engine/world/fields/stand_in.h>
#include <graze/engine/world/rigid/moving_shape.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_motion.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shape_ray.h>
#include <graze/engine/world/shapes/pair_input.h>
#include <graze/engine/world/shapes/quick_gap.h>
#include <graze/engine/world/shapes/shape_work.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <typeinfo>
#include <utility>

namespace graze {
namespace {

Manifold mirrored(Manifold manifold) {
  for (std::size_t i = 0; i < manifold.size(); ++i) {
    ShapeContact& contact = manifold[i];
    std::swap(contact.point_a, contact.point_b);
    contact.normal = -contact.normal;
    std::swap(contact.feature.a, contact.feature.b);
    std::swap(contact.material_a, contact.material_b);
  }
  return manifold;
}

/// True for pairs whose test costs more than measuring and watching their gap.
bool is_worth_a_gap(PairMethod method) {
  using enum PairMethod;
  return method == Cores || method == MeshVolume || method == MeshCore || method == Meshes;
}

double length_of(double x, double y, double z) {
  return std::sqrt((x * x + y * y) + z * z);
}

/// Returns the distance of the farthest corner of the shape's own box from the frame's origin.
double bounding_radius_of(const Shape& shape) {
  if (shape.kind() == ShapeKind::HalfSpace || shape.kind() == ShapeKind::Plane)
    return std::numeric_limits<double>::infinity();
  const Aabb box = bounding_aabb({shape, Pose::Identity()});
  double side[3];
  for (int i = 0; i < 3; ++i)
    side[i] = std::max(std::abs(box.min.data()[i]), std::abs(box.max.data()[i]));
  return length_of(side[0], side[1], side[2]) * (1 + 0x8p-53);
}

/// Returns by how much a box as law 3 reads it may differ from the box of its placed corners.
double reading_of(const Shape& shape, double bounding_radius) {
  return shape.kind() == ShapeKind::Box ? 4 * kMaxRotationDeviation * bounding_radius : 0;
}

double largest_coordinate(const Pose& pose) {
  const double* t = pose.data() + 12;
  return std::max(std::abs(t[0]), std::max(std::abs(t[1]), std::abs(t[2])));
}

class ShapeBody final : public BodyShape {
 public:
  explicit ShapeBody(const Shape& shape)
      : shape_(shape), bounding_radius_(bounding_radius_of(shape)) {}

  const Shape* shape() const override { return &shape_; }

  bool allows_concurrent_calls() const override { return true; }

  Aabb bounds(const Pose& pose) const override { return bounding_aabb({shape_, pose}); }

  bool touches(const Pose& pose, const BodyShape& other, const Pose& other_pose) const override {
    return bvh::in_standard_arithmetic([&]() -> bool {
      const Shape* shape = other.shape();
      if (shape == nullptr) {
        return bvh::in_users_arithmetic([&] { return other.touches(other_pose, *this, pose); });
      }
      return intersect_in_boxes({shape_, pose}, {*shape, other_pose}, shape_work());
    });
  }

  Manifold contacts(const Pose& pose, const BodyShape& other,
                    const Pose& other_pose) const override {
    return bvh::in_standard_arithmetic([&]() -> Manifold {
      const Shape* shape = other.shape();
      if (shape == nullptr) {
        return bvh::in_users_arithmetic(
            [&] { return mirrored(other.contacts(other_pose, *this, pose)); });
      }
      // No finite translation parts two half-spaces: they touch, and have no contact.
      if (pair_method(shape_.kind(), shape->kind()) == PairMethod::Planes) return {};
      Manifold found;
      contacts_in_boxes({shape_, pose}, {*shape, other_pose}, shape_work(), found);
      return found;
    });
  }

  Manifold contacts_within(const Pose& pose, const BodyShape& other, const Pose& other_pose,
                           double margin) const override {
    return bvh::in_standard_arithmetic([&]() -> Manifold {
      const Shape* shape = other.shape();
      if (shape == nullptr) {
        return bvh::in_users_arithmetic(
            [&] { return mirrored(other.contacts_within(other_pose, *this, pose, margin)); });
      }
      if (pair_method(shape_.kind(), shape->kind()) == PairMethod::Planes) return {};
      Manifold found;
      graze::contacts_within({shape_, pose}, {*shape, other_pose}, {.margin = margin}, shape_work(),
                             found);
      return found;
    });
  }

  std::optional<Manifold> meet(const Pose& pose, const BodyShape& other,
                               const Pose& other_pose) const override {
    return bvh::in_standard_arithmetic([&]() -> std::optional<Manifold> {
      const Shape* shape = other.shape();
      if (shape == nullptr) {
        return bvh::in_users_arithmetic([&] {
          std::optional<Manifold> found = other.meet(other_pose, *this, pose);
          if (found) found = mirrored(*found);
          return found;
        });
      }
      if (pair_method(shape_.kind(), shape->kind()) == PairMethod::Planes)
        return BodyShape::meet(pose, other, other_pose);
      // The manifold is empty exactly when the two do not touch.
      Manifold found;
      contacts_in_boxes({shape_, pose}, {*shape, other_pose}, shape_work(), found);
      if (found.empty()) return std::nullopt;
      return found;
    });
  }

  /// distance() proves a length by which the two can near each other before they meet. touches()
  /// may say "hit" at kTouchTolerance of the pair's scale before that. With s = the two bounding
  /// radii and the distance of the origins now, that scale is at most 6 s, and at most 12 s after a
  /// motion that is less than the gap, itself at most s. Placing, by law 1 or law 3, moves points
  /// by less than 0x10p-53 of the largest coordinates, of which a motion less than the gap makes at
  /// most s more. A box that meets a mesh is read by law 3, and by then in a pose that may deviate
  /// from a rotation by as much as is accepted: see bounding_aabb().
  double gap(const Pose& pose, const BodyShape& other, const Pose& other_pose) const override {
    return bvh::in_standard_arithmetic([&]() -> double {
      const Shape* shape = other.shape();
      if (shape == nullptr) return 0;
      if (has_field({shape_, pose}, {*shape, other_pose})) return 0;
      const PairMethod method = pair_method(shape_.kind(), shape->kind());
      if (is_gap_quick(method) && method != PairMethod::MeshVolume)
        return quick_gap({shape_, pose, bounding_radius_},
                         {*shape, other_pose, other.bounding_radius()});
      if (!is_worth_a_gap(method)) return 0;
      const double* t = pose.data() + 12;
      const double* o = other_pose.data() + 12;
      const double scale = length_of(t[0] - o[0], t[1] - o[1], t[2] - o[2]) +
                           (bounding_radius_ + other.bounding_radius());
      const double rounding =
          0x40p-53 * (largest_coordinate(pose) + largest_coordinate(other_pose) + scale);
      const double lower = lower_bound(pose, *shape, other_pose,
                                       std::min(bounding_radius_, other.bounding_radius()));
      const double readings =
          reading_of(shape_, bounding_radius_) + reading_of(*shape, other.bounding_radius());
      return std::max(lower - (16 * kTouchTolerance * scale + rounding + readings), 0.0);
    });
  }

  /// Returns a lower bound of the distance. The distance of two meshes itself is seldom worth its
  /// cost: if they are farther apart than a clearance, half of that is the bound, as distance() is
  /// off by the rounding of coordinates.
  double lower_bound(const Pose& pose, const Shape& shape, const Pose& other_pose,
                     double smaller_radius) const {
    const Mesh* mesh = shape_.as<Mesh>();
    const Mesh* other = shape.as<Mesh>();
    if (pair_method(shape_.kind(), shape.kind()) == PairMethod::MeshVolume) {
      const PlacedShapeView own{shape_, pose}, others{shape, other_pose};
      return mesh == nullptr ? mesh_distance_bound(own, others, shape_work())
                             : mesh_distance_bound(others, own, shape_work());
    }
    if (mesh == nullptr || other == nullptr)
      return distance({shape_, pose}, {shape, other_pose}, &shape_work()).lower_bound;
    const double clearance = smaller_radius / 64;
    const bool is_near = within({*mesh, pose}, {*other, other_pose}, clearance, {}, &shape_work());
    return is_near ? 0 : 0.5 * clearance;
  }

  std::optional<RayHit> cast_ray(const Pose& pose, const Ray& ray) const override {
    return graze::cast_ray({shape_, pose}, ray);
  }

  RigidContact first_contact(const RigidMotion& motion, const BodyShape& other,
                             const RigidMotion& other_motion,
                             const RigidContactSettings& settings) const override {
    return bvh::in_standard_arithmetic([&]() -> RigidContact {
      const Shape* shape = other.shape();
      if (shape != nullptr) {
        return first_contact_of_shapes(shape_, motion, *shape, other_motion, settings,
                                       &shape_work());
      }
      return bvh::in_users_arithmetic(
          [&] { return other.first_contact(other_motion, *this, motion, settings); });
    });
  }

  double bounding_radius() const override { return bounding_radius_; }

 private:
  Shape shape_;
  double bounding_radius_;
};

}  // namespace

Manifold BodyShape::contacts(const Pose& /*pose*/, const BodyShape& /*other*/,
                             const Pose& /*other_pose*/) const {
  return {};
}

Manifold BodyShape::contacts_within(const Pose& pose, const BodyShape& other,
                                    const Pose& other_pose, double /*margin*/) const {
  return touches(pose, other, other_pose) ? contacts(pose, other, other_pose) : Manifold{};
}

std::optional<Manifold> BodyShape::meet(const Pose& pose, const BodyShape& other,
                                        const Pose& other_pose) const {
  if (!touches(pose, other, other_pose)) return std::nullopt;
  return contacts(pose, other, other_pose);
}

double BodyShape::gap(const Pose& /*pose*/, const BodyShape& /*other*/,
                      const Pose& /*other_pose*/) const {
  return 0;
}

std::optional<RayHit> BodyShape::cast_ray(const Pose& /*pose*/, const Ray& /*ray*/) const {
  throw UnsupportedPairError("cast_ray: a shape of a user's own does not know where rays meet it");
}

RigidContact BodyShape::first_contact(const RigidMotion& /*motion*/, const BodyShape& /*other*/,
                                      const RigidMotion& /*other_motion*/,
                                      const RigidContactSettings& /*settings*/) const {
  return {.status = RigidStatus::Close, .low = 0, .high = 1, .is_out_of_budget = true};
}

double BodyShape::bounding_radius() const {
  return std::numeric_limits<double>::infinity();
}

bool is_users_shape(const BodyShape& shape) {
  return typeid(shape) != typeid(ShapeBody) && as_parts(shape) == nullptr;
}

std::shared_ptr<const BodyShape> share(const Shape& shape) {
  return bvh::in_standard_arithmetic(
      [&]() -> std::shared_ptr<const BodyShape> { return std::make_shared<ShapeBody>(shape); });
}

}  // namespace graze
