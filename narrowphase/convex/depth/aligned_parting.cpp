#include <graze/narrowphase/convex/depth/aligned_parting.h>

#include <cmath>

namespace graze::narrowphase {
namespace {

/// Says which of a core's axes matter.
enum class Axes { Unknown, None, Last, All };

bool is_ball(const Core& core) {
  return core.kind == CoreKind::Ellipsoid && core.half.x == core.half.y &&
         core.half.y == core.half.z;
}

Axes axes_of(const Core& core) {
  switch (core.kind) {
    case CoreKind::Point:
      return Axes::None;
    case CoreKind::Segment:
    case CoreKind::Cylinder:
    case CoreKind::Cone:
      return Axes::Last;
    case CoreKind::Box:
      return Axes::All;
    case CoreKind::Ellipsoid:
      return is_ball(core) ? Axes::None : Axes::All;
    default:
      return Axes::Unknown;
  }
}

double coordinate(const Vec3& v, int k) {
  return k == 0 ? v.x : k == 1 ? v.y : v.z;
}

struct Frame {
  Vec3 axis[3];  ///< orthonormal
};

/// Returns the frame about `last` whose first axis is as near to `first` as it may be.
Frame frame_about(const Vec3& last, const Vec3& first) {
  const Vec3 f2 = unit_or(last, {0, 0, 1});
  const Vec3 f0 = unit_or(first - f2 * dot(first, f2), any_normal_to(f2));
  return {{f0, cross(f2, f0), f2}};
}

class Alignment {
 public:
  Alignment(const Core& a, const Core& b, double tolerance)
      : a_(a), b_(b), tolerance_(tolerance), between_(b.at - a.at) {}

  std::optional<Penetration> run() {
    const Axes of_a = axes_of(a_), of_b = axes_of(b_);
    if (of_a == Axes::Unknown || of_b == Axes::Unknown) return std::nullopt;
    const bool has_cone = a_.kind == CoreKind::Cone || b_.kind == CoreKind::Cone;
    is_turned_ = of_a != Axes::All && of_b != Axes::All;
    if (has_cone && !is_turned_) return std::nullopt;
    if (of_a < of_b) {
      choose_frame(b_, a_);
    } else {
      choose_frame(a_, b_);
    }
    if (has_cone && !(is_about_last(a_, of_a) && is_about_last(b_, of_b))) return std::nullopt;
    off_ = deviation(a_, of_a) * a_.bounding_radius + deviation(b_, of_b) * b_.bounding_radius;
    if (!is_off_by_little()) return std::nullopt;
    if (of_a == Axes::None && of_b == Axes::None) {
      offer(between_);
      return found_if_sure();
    }
    return has_cone ? along_sides() : along_axes();
  }

 private:
  bool is_off_by_little() const { return 2 * off_ <= tolerance_; }

  /// Chooses a frame about the core's axis. For two bodies of revolution its first axis leads
  /// towards the other's middle or, if that is not aside, along the other's axis if that is.
  void choose_frame(const Core& core, const Core& other) {
    frame_ = frame_about(core.axis[2], core.axis[0]);
    if (!is_turned_) return;
    const auto across = [&](const Vec3& v) { return v - frame_.axis[2] * dot(v, frame_.axis[2]); };
    const Vec3 aside = across(between_);
    const Vec3 axis = axes_of(other) == Axes::Last ? across(other.axis[2]) : Vec3{};
    if (4 * length(aside) > tolerance_) {
      frame_ = frame_about(core.axis[2], aside);
    } else if (length(axis) > 0.5) {
      frame_ = frame_about(core.axis[2], axis);
    }
  }

  /// True if the core is turned about the frame's last axis, or about any.
  bool is_about_last(const Core& core, Axes axes) const {
    return axes == Axes::None || nearest_axis(core.axis[2]) == 2;
  }

  /// Returns the axis of the frame along which a direction points most.
  int nearest_axis(const Vec3& direction) const {
    int nearest = 0;
    for (int k = 1; k < 3; ++k) {
      const double most = std::abs(dot(direction, frame_.axis[nearest]));
      if (std::abs(dot(direction, frame_.axis[k])) > most) nearest = k;
    }
    return nearest;
  }

  double distance_to_axis(const Vec3& direction) const {
    const Vec3& axis = frame_.axis[nearest_axis(direction)];
    return length(direction - axis * (dot(direction, axis) < 0 ? -1.0 : 1.0));
  }

  /// Returns a bound of how far points of the core are from where they would be if its axes were
  /// the frame's, as a share of its bounding radius.
  double deviation(const Core& core, Axes axes) const {
    const Vec3* axis = core.axis;
    const double last = distance_to_axis(axis[2]);
    if (axes == Axes::All) return last + distance_to_axis(axis[0]) + distance_to_axis(axis[1]);
    // A body turned about its last axis, or a ball, turned about any, is off by how far from
    // orthonormal the axes are.
    double off = axes == Axes::Last ? last : std::abs(dot(axis[2], axis[2]) - 1);
    for (int k = 0; k < 2; ++k)
      off += std::abs(dot(axis[k], axis[k]) - 1) + 2 * std::abs(dot(axis[k], axis[2]));
    return core.kind == CoreKind::Point ? 0 : off + 2 * std::abs(dot(axis[0], axis[1]));
  }

  /// Returns how long a core is along an axis of the frame, as far as that is a corner or an edge.
  double half_along(const Core& core, int k) const {
    if (core.kind == CoreKind::Box) {
      double half = 0;
      for (int i = 0; i < 3; ++i) {
        if (nearest_axis(core.axis[i]) == k) half += coordinate(core.half, i);
      }
      return half;
    }
    if (core.kind != CoreKind::Segment && core.kind != CoreKind::Cylinder) return 0;
    if (nearest_axis(core.axis[2]) == k) return core.half.z;
    return is_turned_ && k == 0 && core.kind == CoreKind::Cylinder ? core.half.x : 0;
  }

  std::optional<Penetration> along_axes() {
    for (int k = 0; k < 3; ++k) {
      const double offset = dot(between_, frame_.axis[k]);
      const double excess = std::abs(offset) - (half_along(a_, k) + half_along(b_, k));
      if (excess > 0) off_ += excess;
      offer(offset < 0 ? -frame_.axis[k] : frame_.axis[k]);
    }
    return found_if_sure();
  }

  std::optional<Penetration> along_sides() {
    const Vec3& last = frame_.axis[2];
    const Vec3& aside = frame_.axis[0];
    off_ += length(between_ - last * dot(between_, last));
    for (const Vec3& direction : {last, -last, aside})
      offer(direction);
    if (a_.kind == CoreKind::Cone) offer(aside * (2 * a_.half.z) + a_.axis[2] * a_.half.x);
    if (b_.kind == CoreKind::Cone) offer(aside * (2 * b_.half.z) - b_.axis[2] * b_.half.x);
    // The middle must lie inside the difference of the polygons.
    if (!(best_->depth - (rounding_of(a_) + rounding_of(b_)) >= 0)) return std::nullopt;
    return found_if_sure();
  }

  /// Returns the radius around a polygon; a ball has nothing else.
  static double rounding_of(const Core& core) {
    return core.radius + (is_ball(core) ? core.half.x : 0);
  }

  void offer(const Vec3& direction) {
    const Penetration found = along(a_, b_, unit_or(direction, frame_.axis[2]));
    if (!best_ || found.depth < best_->depth) best_ = found;
  }

  std::optional<Penetration> found_if_sure() {
    if (!is_off_by_little()) return std::nullopt;
    best_->source = PenetrationSource::Formula;
    best_->lower = best_->depth - 2 * off_;
    return best_;
  }

  const Core& a_;
  const Core& b_;
  double tolerance_;
  Vec3 between_;
  Frame frame_;
  bool is_turned_ = false;  ///< true if both are bodies of revolution
  double off_ = 0;          ///< metres by which supports differ from those of aligned sets
  std::optional<Penetration> best_;
};

}  // namespace

std::optional<Penetration> part_aligned(const Core& a, const Core& b, double tolerance) {
  return Alignment(a, b, tolerance).run();
}

}  // namespace graze::narrowphase
