#include "tests/engine/special_poses/pair_laws.h"

#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>

#include "tests/engine/special_poses/pair_text.h"
#include "tests/engine/special_poses/special_pairs.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/engine/world/surface_distance.h"

namespace graze::tests {

using Eigen::Vector3d;

namespace {

// What manifold.h and shape_pairs.h promise.
constexpr double kDepthTolerance = 1e-6;
constexpr double kBoxEdgeShare = 1 / 0.95;
constexpr double kContactPoints = 0x1p-32;
constexpr double kPointRounding = 0x1p-45;
constexpr double kMeetingPoints = 0x1p-30;
constexpr double kMeshContactPoints = 1e-9;
constexpr double kShallow = 0.1;  // of the smaller size: so deep law 15 says the ways of meshes

std::string numbers(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, " %.17g", value);
    text += buffer;
  }
  return text;
}

bool is_same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool is_same_bits(const Vector3d& a, const Vector3d& b) {
  return is_same_bits(a.x(), b.x()) && is_same_bits(a.y(), b.y()) && is_same_bits(a.z(), b.z());
}

bool is_opposite(const Vector3d& a, const Vector3d& b) {
  return is_same_bits(a, Vector3d(-b));
}

class Laws {
 public:
  Laws(const PlacedPair& pair, const PairLawSettings& settings, PairLawCounts& counts)
      : pair_(pair), settings_(settings), counts_(counts), scale_(scale_of(pair)) {
    const double far = pair.pose_a.translation().norm() + pair.pose_b.translation().norm() + scale_;
    rounding_ = kPointRounding * far;
    is_hit_ = intersects({pair.a, pair.pose_a}, {pair.b, pair.pose_b}, &test_work_);
    found_ = distance({pair.a, pair.pose_a}, {pair.b, pair.pose_b});
    manifold_ = find_contacts({pair.a, pair.pose_a}, {pair.b, pair.pose_b}, &work_);
  }

  std::string run() {
    ++counts_.pairs;
    counts_.hits += is_hit_;
    counts_.unconverged += found_.status == PairStatus::NotConverged;
    const bool has_mesh = pair_.a.kind() == ShapeKind::Mesh || pair_.b.kind() == ShapeKind::Mesh;
    const auto gaps = has_mesh ? &Laws::gaps_of_surfaces : &Laws::distances;
    const auto least = has_mesh ? &Laws::agreement : &Laws::depths;
    for (const auto& law : {&Laws::agreement, &Laws::swapping, gaps, &Laws::points, least}) {
      const std::string broken = (this->*law)();
      if (!broken.empty()) return broken;
    }
    return {};
  }

 private:
  std::string agreement() {
    if ((found_.distance == 0) != is_hit_) return "distance 0 is not a hit";
    if (manifold_.empty() == is_hit_) return "a hit without contacts, or contacts without a hit";
    if (!(std::abs(found_.normal.norm() - 1) < 1e-14)) return "the normal is not of length 1";
    return {};
  }

  std::string swapping() {
    const PlacedPair& p = pair_;
    if (intersects({p.b, p.pose_b}, {p.a, p.pose_a}) != is_hit_)
      return "swapped: another yes or no";
    const ShapeDistance other = distance({p.b, p.pose_b}, {p.a, p.pose_a});
    if (!is_same_bits(other.distance, found_.distance) ||
        !is_same_bits(other.lower_bound, found_.lower_bound) || other.status != found_.status) {
      return "swapped: another distance";
    }
    if (text_of(p) == text_of({p.b, p.a, p.pose_b, p.pose_a})) {
      // There is nothing to mirror: both questions are the same one.
      return is_same_bits(other.normal, found_.normal) ? "" : "two answers to one question";
    }
    if (!is_same_bits(other.point_a, found_.point_b) ||
        !is_same_bits(other.point_b, found_.point_a)) {
      return "swapped: other points";
    }
    if (!is_opposite(other.normal, found_.normal)) return "swapped: the normal is not mirrored";
    const Manifold mirrored = find_contacts({p.b, p.pose_b}, {p.a, p.pose_a});
    if (mirrored.size() != manifold_.size()) return "swapped: another number of contacts";
    for (std::size_t i = 0; i < mirrored.size(); ++i) {
      const ShapeContact& s = manifold_[i];
      const ShapeContact& t = mirrored[i];
      if (!is_same_bits(s.depth, t.depth) || !is_same_bits(s.point, t.point) ||
          !is_opposite(s.normal, t.normal)) {
        return "swapped: a contact is not mirrored";
      }
    }
    return {};
  }

  std::string distances() {
    const double apart = (found_.point_b - found_.point_a).norm();
    const double out = std::max(outside_by(pair_.a, pair_.pose_a, found_.point_a),
                                outside_by(pair_.b, pair_.pose_b, found_.point_b));
    const double planes = -width_along(pair_, found_.normal);
    if (is_open()) note_open(std::max(out, is_hit_ ? 0 : found_.distance - found_.lower_bound));
    // Where it is a tolerance that decides, the points are known to it as well, but for those of a
    // hit that is none for sure.
    const double tolerance = kTouchTolerance * scale_;
    const double most = found_.distance <= tolerance ? tolerance : 0;
    if (!(is_open() && is_hit_) && out > most + rounding_) {
      return "a point outside its shape:" + numbers({out, found_.distance});
    }
    if (std::abs(apart - found_.distance) > most + rounding_) {
      return "the points are not as far apart as said:" + numbers({apart, found_.distance});
    }
    if (found_.lower_bound > found_.distance) return "the bound is above the distance";
    if (is_hit_) return {};
    if (found_.lower_bound > planes + kPlanes * scale_ + rounding_) {
      return "planes nearer than the bound:" + numbers({planes, found_.lower_bound, scale_});
    }
    if (is_open()) return {};
    const double error = std::max(found_.distance - planes, found_.distance - found_.lower_bound);
    counts_.worst_distance = std::max(counts_.worst_distance, error / tolerance);
    const double off = std::max(Surface(pair_.a).distance(pair_.pose_a, found_.point_a),
                                Surface(pair_.b).distance(pair_.pose_b, found_.point_b));
    if (off > kBelowSurface * tolerance + rounding_)
      return "a nearest point beside its surface:" + numbers({off, scale_});
    if (error > tolerance + rounding_) {
      return "the distance is off by more than said:" +
             numbers({found_.distance, planes, found_.lower_bound, scale_});
    }
    return {};
  }

  /// Nobody promises how near to each other the bounds of a search are that ends open, so that this
  /// is counted alone.
  bool is_open() const { return found_.status == PairStatus::NotConverged; }
  void note_open(double error) {
    counts_.worst_open = std::max(counts_.worst_open, error / scale_);
  }

  /// By how much a shape is inside of a mesh of a box; less than 0 if it reaches out of it.
  static double inside_by(const Shape& shape, const Pose& pose, const Shape& mesh,
                          const Pose& mesh_pose) {
    if (mesh.kind() != ShapeKind::Mesh || shape.kind() == ShapeKind::HalfSpace) return -1e300;
    if (mesh.as<Mesh>()->triangles().size() != 12) return -1e300;
    const Vector3d half = mesh.as<Mesh>()->bounds().max;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 6; ++i) {
      const Vector3d axis = mesh_pose.linear().col(i / 2) * (i % 2 == 0 ? 1.0 : -1.0);
      const double reach = reach_along(shape, pose, axis) - axis.dot(mesh_pose.translation());
      least = std::min(least, half(i / 2) - reach);
    }
    return least;
  }

  /// The surface of a box beside a solid or another such surface: apart where planes part the box
  /// from it, and where the one is inside of the other, by as much as the nearest plane is off.
  std::string gaps_of_surfaces() {
    const double inside = std::max(inside_by(pair_.a, pair_.pose_a, pair_.b, pair_.pose_b),
                                   inside_by(pair_.b, pair_.pose_b, pair_.a, pair_.pose_a));
    const LeastWidth least = least_width(pair_, settings_.directions, {found_.normal});
    const double proved = std::max(inside, -least.width);
    const double tolerance = 3 * kTouchTolerance * scale_ + rounding_;
    const double out = std::max(outside_by(pair_.a, pair_.pose_a, found_.point_a),
                                outside_by(pair_.b, pair_.pose_b, found_.point_b));
    const double apart = (found_.point_b - found_.point_a).norm();
    ++counts_.surfaces;
    if (is_open())
      note_open(is_hit_ ? std::max(proved, 0.0) : found_.distance - found_.lower_bound);
    if (found_.lower_bound > found_.distance) return "the bound is above the distance";
    if (is_hit_ && !is_open() && proved > tolerance) {
      return "a hit of shapes that are apart:" + numbers({proved, scale_});
    }
    if (is_hit_) return {};
    if (proved < -tolerance) return "apart, but they touch:" + numbers({proved, scale_});
    if (out > tolerance) return "a point outside its shape:" + numbers({out, scale_});
    if (std::abs(apart - found_.distance) > tolerance) {
      return "the points are not as far apart as said:" + numbers({apart, found_.distance});
    }
    if (is_open()) return {};
    if (std::abs(found_.distance - std::max(proved, 0.0)) > tolerance) {
      return "the distance is off by more than said:" + numbers({found_.distance, proved, scale_});
    }
    return {};
  }

  /// Each point of a contact is on the surface that it names, unless a search left the hit open.
  std::string points() {
    if (!is_hit_) return {};
    if (pair_.a.kind() == ShapeKind::Mesh && pair_.b.kind() == ShapeKind::Mesh)
      return points_of_meshes();
    const Surface of_a(pair_.a), of_b(pair_.b);
    const double most = kContactPoints * scale_ + rounding_;
    for (const ShapeContact& contact : manifold_) {
      const double off = std::max(of_a.distance(pair_.pose_a, contact.point_a),
                                  of_b.distance(pair_.pose_b, contact.point_b));
      if (is_open()) {
        note_open(off);
        continue;
      }
      counts_.worst_point = std::max(counts_.worst_point, off / most);
      if (!(off <= most)) return "a contact beside a surface:" + numbers({off, scale_});
      const double aside =
          (contact.point_a - contact.point_b - contact.depth * contact.normal).norm();
      if (!(aside <= most + most_aside(contact.depth)))
        return "a contact beside its way:" + numbers({aside, contact.depth, scale_});
    }
    return {};
  }

  /// Of two meshes, as far as depths go for which ways out are promised: one point is on its
  /// surface, and the other on a plane that its mesh has there.
  std::string points_of_meshes() {
    const Surface of_a(pair_.a), of_b(pair_.b);
    const double most = kMeshContactPoints * scale_ + rounding_;
    for (const ShapeContact& contact : manifold_) {
      if (contact.depth > kShallow * smaller_size(pair_)) continue;
      const double on_a = of_a.distance(pair_.pose_a, contact.point_a);
      const double on_b = of_b.distance(pair_.pose_b, contact.point_b);
      const double plane_a = off_planes(pair_.a, pair_.pose_a, contact.point_a, contact.normal);
      const double plane_b = off_planes(pair_.b, pair_.pose_b, contact.point_b, contact.normal);
      const double off = std::min(std::max(on_a, plane_b), std::max(on_b, plane_a));
      counts_.worst_mesh_point = std::max(counts_.worst_mesh_point, off / most);
      if (!(off <= most)) return "a contact of meshes beside both:" + numbers({off, scale_});
      const double aside =
          (contact.point_a - contact.point_b - contact.depth * contact.normal).norm();
      if (!(aside <= most))
        return "a contact of meshes beside its way:" + numbers({aside, contact.depth, scale_});
    }
    return {};
  }

  /// How far a point is from the nearest plane of a box's face, or at right angles to the normal
  /// through one of its corners.
  static double off_planes(const Shape& mesh, const Pose& pose, const Vector3d& point,
                           const Vector3d& normal) {
    const Vector3d half = mesh.as<Mesh>()->bounds().max;
    const Vector3d own = pose.linear().transpose() * (point - pose.translation());
    double least = (own.cwiseAbs() - half).cwiseAbs().minCoeff();
    for (int i = 0; i < 8; ++i) {
      const Vector3d corner =
          half.cwiseProduct(Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
      least = std::min(least, std::abs(normal.dot(pose.linear() * (own - corner))));
    }
    return least;
  }

  /// How far point_a may be from where the normal leads from point_b; without end where that is no
  /// promise.
  double most_aside(double depth) const {
    const auto is = [&](ShapeKind kind) {
      return pair_.a.kind() == kind || pair_.b.kind() == kind;
    };
    if (is(ShapeKind::HalfSpace)) return 0;
    if (work_.penetration_failures > 0) return std::numeric_limits<double>::infinity();
    const bool has_round = is(ShapeKind::Sphere) || is(ShapeKind::Capsule);
    const double of_meeting =
        std::max(0x1p-17 * smaller_size(pair_), has_round ? 0x1p-16 * scale_ : 0);
    const bool has_box = is(ShapeKind::Box);
    return of_meeting + kMeetingPoints * scale_ + (has_box ? depth / 19 : 0);
  }

  std::string depths() {
    if (!is_hit_) return {};
    const LeastWidth least = least_width(pair_, settings_.directions, {manifold_[0].normal});
    if (test_work_.convex_failures > 0) {
      note_open(-least.width);
    } else if (least.width < -kTouchTolerance * scale_ - rounding_) {
      return "a hit of shapes that are apart:" + numbers({least.width, scale_});
    }
    const double depth = manifold_[0].depth;
    const double along = width_along(pair_, manifold_[0].normal);
    double spread = 0;
    for (const ShapeContact& contact : manifold_)
      spread = std::max(spread, (contact.point - manifold_[0].point).norm());
    const double size = smaller_size(pair_);
    const double kept =
        std::max(kSpread * spread, kDepthTolerance * size) + kTouchTolerance * scale_ + rounding_;
    if (depth < along - kept) {
      return "the depth does not part them:" + numbers({depth, along, spread});
    }
    if (depth > std::max(along, 0.0) + kept) {
      return "the depth is not that of its normal:" + numbers({depth, along, spread});
    }
    counts_.unproved += work_.penetration_failures > 0;
    if (work_.penetration_failures > 0) {
      counts_.worst_unproved = std::max(counts_.worst_unproved, (along - least.width) / size);
      return {};
    }
    ++counts_.depths;
    const bool are_boxes = pair_.a.kind() == ShapeKind::Box && pair_.b.kind() == ShapeKind::Box;
    const double tolerance = kDepthTolerance * size + kTouchTolerance * scale_ + rounding_;
    const double most = std::max(least.width, 0.0) * (are_boxes ? kBoxEdgeShare : 1) + tolerance;
    if (!are_boxes) {
      counts_.worst_depth = std::max(counts_.worst_depth, (along - least.width) / tolerance);
    }
    if (along > most) {
      return "deeper than need be:" + numbers({depth, along, least.width, least.direction.x(),
                                               least.direction.y(), least.direction.z()});
    }
    return {};
  }

  // Rounding of the planes that a normal sets, as a share of the scale.
  static constexpr double kPlanes = 0x1p-46;
  static constexpr double kSpread = 1e-4;
  // Of a point is asked to be on its surface or below it by the tolerance; what Surface says of an
  // ellipsoid is right to a ten-thousandth.
  static constexpr double kBelowSurface = 1.001;

  const PlacedPair& pair_;
  const PairLawSettings& settings_;
  PairLawCounts& counts_;
  double scale_;
  double rounding_;
  bool is_hit_;
  ShapeDistance found_;
  Manifold manifold_;
  Work work_;
  Work test_work_;
};

}  // namespace

std::string broken_law(const PlacedPair& pair, const PairLawSettings& settings,
                       PairLawCounts& counts) {
  return Laws(pair, settings, counts).run();
}

// What lies at a tolerance may come out either way, and so may what a search leaves open.
std::string broken_scaling(const PlacedPair& pair, double factor) {
  const PlacedPair other = scaled(pair, factor);
  const double scale = scale_of(pair);
  const double touch = 4 * kTouchTolerance * scale;
  Work work, other_work;
  const Manifold here = find_contacts({pair.a, pair.pose_a}, {pair.b, pair.pose_b}, &work);
  const Manifold there =
      find_contacts({other.a, other.pose_a}, {other.b, other.pose_b}, &other_work);
  const ShapeDistance near = distance({pair.a, pair.pose_a}, {pair.b, pair.pose_b});
  const ShapeDistance far = distance({other.a, other.pose_a}, {other.b, other.pose_b});
  if (near.status == PairStatus::NotConverged || far.status == PairStatus::NotConverged) return {};
  if (std::abs(far.distance / factor - near.distance) > touch)
    return "scaled: another distance:" + numbers({near.distance, far.distance / factor});
  if (std::abs(far.lower_bound / factor - near.lower_bound) > touch)
    return "scaled: another bound:" + numbers({near.lower_bound, far.lower_bound / factor});
  const double here_depth = here.empty() ? 0 : here[0].depth;
  const double there_depth = there.empty() ? 0 : there[0].depth / factor;
  const bool is_touching = here_depth <= touch && there_depth <= touch;
  if (here.empty() != there.empty() && !is_touching) return "scaled: another yes or no";
  if (work.penetration_failures + other_work.penetration_failures > 0) return {};
  const bool are_boxes = pair.a.kind() == ShapeKind::Box && pair.b.kind() == ShapeKind::Box;
  const bool has_mesh = pair.a.kind() == ShapeKind::Mesh || pair.b.kind() == ShapeKind::Mesh;
  const double share = are_boxes || has_mesh ? 0.06 * std::max(here_depth, there_depth) : 0;
  if (has_mesh && pair.a.kind() == pair.b.kind()) return {};  // whose depths are a guide
  if (std::abs(here_depth - there_depth) > 2e-6 * smaller_size(pair) + touch + share)
    return "scaled: another depth:" + numbers({here_depth, there_depth});
  return {};
}

}  // namespace graze::tests
