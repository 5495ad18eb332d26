#include <graze/narrowphase/convex/core/hull.h>
#include <graze/narrowphase/convex/core/segments.h>
#include <graze/narrowphase/convex/depth/facing_depth.h>
#include <graze/narrowphase/convex/gap/closed_gap.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::narrowphase {
namespace {

/// A direction of an arc: the cosine and the sine of its angle to the first.
struct Turn {
  double cosine = 1;
  double sine = 0;
};

/// Positive if `t` is less than half a turn on from `s`.
double between(const Turn& s, const Turn& t) {
  return s.cosine * t.sine - s.sine * t.cosine;
}

/// Says by how much one support point reaches beyond the edge: a cos(t) + b sin(t).
struct Sinusoid {
  double a = 0;
  double b = 0;
  double at(const Turn& turn) const { return a * turn.cosine + b * turn.sine; }
};

/// A part of the arc, at most a right angle, between two directions whose support points are known.
struct Interval {
  Turn from, to;
  Sinusoid of_from, of_to;
  double bound;  ///< no direction between has a depth below that
  Turn where;    ///< the direction of the least depth between, as far as the two ends know
};

void bound(Interval& interval) {
  const Sinusoid &s = interval.of_from, &t = interval.of_to;
  interval.bound = std::numeric_limits<double>::infinity();
  interval.where = interval.from;
  const auto offer = [&](double cosine, double sine) {
    const double size = std::sqrt(cosine * cosine + sine * sine);
    const Turn turn{cosine / size, sine / size};
    if (!(between(interval.from, turn) > 0) || !(between(turn, interval.to) > 0)) return;
    const double value = std::max(s.at(turn), t.at(turn));
    if (value < interval.bound) interval.bound = value, interval.where = turn;
  };
  // The least is where both are equal, or where either is least.
  offer(t.b - s.b, s.a - t.a), offer(s.b - t.b, t.a - s.a);
  offer(-s.a, -s.b), offer(-t.a, -t.b);
}

class ArcSearch {
 public:
  ArcSearch(const Core& core, const Vec3& corner, const DirectionArc& arc)
      : core_(core), corner_(corner), arc_(arc) {}

  Exit run(const Vec3& deepest, double limit) {
    const Turn first{}, last{arc_.cosine, arc_.sine};
    const Sinusoid of_first = note(deepest, first), of_last = ask(last);
    if (arc_.cosine < 0) {
      const Turn aside{0, 1};
      const Sinusoid of_aside = ask(aside);
      push({first, aside, of_first, of_aside, 0, {}});
      push({aside, last, of_aside, of_last, 0, {}});
    } else {
      push({first, last, of_first, of_last, 0, {}});
    }
    const double tolerance = kFacingTolerance * (core_.bounding_radius + core_.radius);
    while (count_ > 0 && supports_ < kMostSupports) {
      Interval* lowest =
          std::min_element(open_, open_ + count_,
                           [](const Interval& s, const Interval& t) { return s.bound < t.bound; });
      const Interval halved = *lowest;
      if (!(halved.bound < least_ - tolerance) || halved.bound >= limit - core_.radius) break;
      *lowest = open_[--count_];
      const Sinusoid middle = ask(halved.where);
      push({halved.from, halved.where, halved.of_from, middle, 0, {}});
      push({halved.where, halved.to, middle, halved.of_to, 0, {}});
    }
    return {direction(best_), least_ + core_.radius};
  }

 private:
  Vec3 direction(const Turn& turn) const {
    return unit_or(arc_.first * turn.cosine + arc_.aside * turn.sine, arc_.first);
  }

  Sinusoid ask(const Turn& turn) {
    ++supports_;
    return note(support(core_, -direction(turn)), turn);
  }

  /// Takes the support point against a direction of the arc.
  Sinusoid note(const Vec3& point, const Turn& turn) {
    const Vec3 from = corner_ - point;
    const Sinusoid found{dot(arc_.first, from), dot(arc_.aside, from)};
    const double depth = found.at(turn);
    if (depth < least_) least_ = depth, best_ = turn;
    return found;
  }

  void push(Interval interval) {
    bound(interval);
    if (interval.bound < least_) open_[count_++] = interval;
  }

  const Core& core_;
  const Vec3& corner_;
  const DirectionArc& arc_;
  Interval open_[kMostSupports + 4];
  int count_ = 0;
  int supports_ = 0;
  double least_ = std::numeric_limits<double>::infinity();
  Turn best_;
};

/// Returns the outward normal at the nearest point of the surface, which is `depth` away, by
/// bisection for the multiplier of that point. Eberly, "Distance from a Point to an Ellipse, an
/// Ellipsoid, or a Hyperellipsoid" (2013).
std::optional<Vec3> nearest_normal(const Core& core, const Vec3& own, double& depth) {
  const Vec3& e = core.half;
  const auto beyond = [&](double t) {
    const Vec3 r{e.x * own.x / (t + e.x * e.x), e.y * own.y / (t + e.y * e.y),
                 e.z * own.z / (t + e.z * e.z)};
    return dot(r, r) - 1;
  };
  if (!(beyond(0) < 0)) return std::nullopt;
  const double least = std::min({e.x, e.y, e.z});
  double low = -least * least, high = 0;
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    (beyond(middle) < 0 ? high : low) = middle;
  }
  // Where the point is in the plane of symmetry across the least axis, the nearest point is not.
  Vec3 met{e.x * e.x * own.x / (high + e.x * e.x), e.y * e.y * own.y / (high + e.y * e.y),
           e.z * e.z * own.z / (high + e.z * e.z)};
  const Vec3 share{met.x / e.x, met.y / e.y, met.z / e.z};
  const double missing = std::sqrt(std::max(1 - dot(share, share), 0.0));
  double& across = e.x == least ? met.x : e.y == least ? met.y : met.z;
  across += std::copysign(missing * least, across);
  const Vec3 outward =
      unit_or({met.x / (e.x * e.x), met.y / (e.y * e.y), met.z / (e.z * e.z)}, {0, 0, 1});
  depth = dot(outward, met - own);
  return outward;
}

}  // namespace

Exit least_on_arc(const Core& core, const Vec3& corner, const DirectionArc& arc,
                  const Vec3& deepest, double limit) {
  return ArcSearch(core, corner, arc).run(deepest, limit);
}

CornerExits::CornerExits(const Core& core, const Vec3& corner)
    : core_(core), corner_(corner), own_(into_own(core, corner - core.at)) {
  switch (core.kind) {
    case CoreKind::Point:
    case CoreKind::Segment:
    case CoreKind::Ellipsoid:
      parts_ = 1;
      break;
    case CoreKind::Box:
      parts_ = 6;
      break;
    case CoreKind::Cylinder:
      parts_ = 3;
      break;
    case CoreKind::Cone:
      parts_ = 2;
      break;
    case CoreKind::Points:
      parts_ = core.hull != nullptr ? core.hull->faces.size() : 0;
      break;
    case CoreKind::Triangle:
      break;
  }
}

std::optional<Exit> CornerExits::next(double limit) {
  while (part_ < parts_) {
    if (core_.kind == CoreKind::Points) {
      const Hull& hull = *core_.hull;
      const std::size_t face = part_++;
      const double depth = hull.offsets[face] - dot(hull.faces[face].normal, own_) + core_.radius;
      if (depth < limit) return exit(hull.faces[face].normal, depth);
      continue;
    }
    std::optional<Exit> found = next_part();
    if (!found) continue;
    if (!is_rounded()) found->depth += core_.radius;
    if (found->depth < limit) return found;
  }
  if (!is_last_asked_) {
    is_last_asked_ = true;
    if (core_.radius > 0 && !is_rounded()) {
      const std::optional<Exit> found = of_nearest();
      if (found && found->depth < limit) return found;
    }
  }
  return std::nullopt;
}

/// True if the parts of the surface are made of the radius.
bool CornerExits::is_rounded() const {
  return core_.kind == CoreKind::Point || core_.kind == CoreKind::Segment;
}

/// Returns the exit from the nearest point of the set grown by the radius, if the corner is outside
/// of the set itself: through the round parts over its edges and corners.
std::optional<Exit> CornerExits::of_nearest() const {
  Core corner;
  corner.at = corner_;
  const CoreGap gap = nearest(core_, corner);
  if (!(gap.upper > 0)) return std::nullopt;
  return Exit{-unit_or(gap.point_b - gap.point_a, {0, 0, 1}), core_.radius - gap.upper};
}

/// Returns the exit where the surface is `depth` from the corner along the outward direction, in
/// the core's frame.
Exit CornerExits::exit(const Vec3& outward, double depth) const {
  return {-unit_or(turned(core_, outward), {0, 0, 1}), depth};
}

std::optional<Exit> CornerExits::next_part() {
  switch (core_.kind) {
    case CoreKind::Point:
    case CoreKind::Segment:
      return of_rounded();
    case CoreKind::Box:
      return of_box();
    case CoreKind::Cylinder:
      return of_cylinder();
    case CoreKind::Cone:
      return of_cone();
    case CoreKind::Ellipsoid: {
      ++part_;
      double depth = 0;
      const std::optional<Vec3> outward = nearest_normal(core_, own_, depth);
      if (!outward) return std::nullopt;
      return exit(*outward, depth);
    }
    case CoreKind::Points:
    case CoreKind::Triangle:
      break;
  }
  return std::nullopt;
}

std::optional<Exit> CornerExits::of_rounded() {
  ++part_;
  const Vec3 half_axis = core_.axis[2] * (core_.kind == CoreKind::Segment ? core_.half.z : 0);
  const Vec3 nearest = nearest_on_segment(core_.at - half_axis, core_.at + half_axis, corner_);
  Vec3 away = corner_ - nearest;
  if (core_.kind == CoreKind::Segment) {
    // For a corner on the segment this is rounding, and no passage through the surface unless it
    // leads across the segment, or out beyond an end.
    const double beyond = own_.z >= core_.half.z ? 1 : own_.z <= -core_.half.z ? -1 : 0;
    const Vec3 axis = unit_or(core_.axis[2], {0, 0, 1});
    for (int i = 0; i < 2 && !(beyond * dot(away, axis) > 0); ++i)
      away = away - axis * dot(away, axis);  // the second step takes away what the first left
  }
  const double distance = length(away);
  if (!(distance > 0)) return std::nullopt;
  return Exit{-unit_or(away, {0, 0, 1}), core_.radius - distance};
}

Exit CornerExits::of_box() {
  const std::size_t side = part_++;
  const double half[3] = {core_.half.x, core_.half.y, core_.half.z};
  const double own[3] = {own_.x, own_.y, own_.z};
  const std::size_t k = side / 2;
  const double sign = side % 2 == 0 ? 1 : -1;
  return {core_.axis[k] * -sign, half[k] - sign * own[k]};
}

Exit CornerExits::of_cylinder() {
  const std::size_t part = part_++;
  if (part < 2) {
    const double sign = part == 0 ? 1 : -1;
    return {core_.axis[2] * -sign, core_.half.z - sign * own_.z};
  }
  const double from_axis = std::sqrt(own_.x * own_.x + own_.y * own_.y);
  return exit(unit_or({own_.x, own_.y, 0}, {1, 0, 0}), core_.half.x - from_axis);
}

Exit CornerExits::of_cone() {
  if (part_++ == 0) return {core_.axis[2], core_.half.z + own_.z};
  const double rise = 2 * core_.half.z, slant = length(Vec3{core_.half.x, 0, rise});
  const Vec3 aside = unit_or({own_.x, own_.y, 0}, {1, 0, 0});
  const double from_axis = std::sqrt(own_.x * own_.x + own_.y * own_.y);
  return exit({aside.x * rise / slant, aside.y * rise / slant, core_.half.x / slant},
              ((core_.half.z - own_.z) * core_.half.x - from_axis * rise) / slant);
}

}  // namespace graze::narrowphase
