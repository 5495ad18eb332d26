#include "tests/engine/special_poses/pair_laws.h"

#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "tests/engine/special_poses/pair_text.h"
#include "tests/engine/world/random_shapes.h"

namespace graze::tests {

using Eigen::Vector3d;

namespace {

// What manifold.h and shape_pairs.h promise.
constexpr double kDepthTolerance = 1e-6;
constexpr double kBoxEdgeShare = 1 / 0.95;

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
    rounding_ = 1e-14 * far;
    is_hit_ = intersects({pair.a, pair.pose_a}, {pair.b, pair.pose_b}, &test_work_);
    found_ = distance({pair.a, pair.pose_a}, {pair.b, pair.pose_b});
    manifold_ = find_contacts({pair.a, pair.pose_a}, {pair.b, pair.pose_b}, &work_);
  }

  std::string run() {
    ++counts_.pairs;
    counts_.hits += is_hit_;
    counts_.unconverged += found_.status == PairStatus::NotConverged;
    for (const auto& law : {&Laws::agreement, &Laws::swapping, &Laws::distances, &Laws::depths}) {
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
    const double share = found_.status == PairStatus::Converged ? kTouchTolerance : kOpen;
    const double apart = (found_.point_b - found_.point_a).norm();
    const double out_a = outside_by(pair_.a, pair_.pose_a, found_.point_a);
    const double out_b = outside_by(pair_.b, pair_.pose_b, found_.point_b);
    // Where it is a tolerance that decides, the points are known to it as well.
    const double most = found_.distance <= share * scale_ ? share * scale_ : 0;
    const bool is_open_hit = is_hit_ && found_.status == PairStatus::NotConverged;
    if (!is_open_hit && (out_a > most + rounding_ || out_b > most + rounding_)) {
      return "a point outside its shape:" + numbers({out_a, out_b, found_.distance});
    }
    if (std::abs(apart - found_.distance) > most + rounding_) {
      return "the points are not as far apart as said:" + numbers({apart, found_.distance});
    }
    if (found_.lower_bound > found_.distance) return "the bound is above the distance";
    if (is_hit_) return {};
    const double planes = -width_along(pair_, found_.normal);
    if (found_.lower_bound > planes + kPlanes * scale_ + rounding_) {
      return "planes nearer than the bound:" + numbers({planes, found_.lower_bound, scale_});
    }
    const double error = std::max(found_.distance - planes, found_.distance - found_.lower_bound);
    counts_.worst_distance = std::max(counts_.worst_distance, error / (share * scale_));
    if (error > share * scale_ + rounding_) {
      return "the distance is off by more than said:" +
             numbers({found_.distance, planes, found_.lower_bound, scale_});
    }
    return {};
  }

  std::string depths() {
    if (!is_hit_) return {};
    const LeastWidth least = least_width(pair_, settings_.directions, {manifold_[0].normal});
    const double touch = test_work_.convex_failures > 0 ? kOpen : kTouchTolerance;
    if (least.width < -touch * scale_ - rounding_) {
      return "a hit of shapes that are apart:" + numbers({least.width, scale_});
    }
    const double depth = manifold_[0].depth;
    const double along = width_along(pair_, manifold_[0].normal);
    double spread = 0;
    for (const ShapeContact& contact : manifold_)
      spread = std::max(spread, (contact.point - manifold_[0].point).norm());
    const double size = std::min(size_about_middle(pair_.a), size_about_middle(pair_.b));
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
  // Of searches that end open, which are counted. Their bounds hold, and nobody promises how near
  // to each other they are.
  static constexpr double kOpen = 4e-6;

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

}  // namespace graze::tests
