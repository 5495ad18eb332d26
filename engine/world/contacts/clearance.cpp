#include <graze/engine/world/contacts/clearance.h>

#include <algorithm>
#include <cmath>

// This minimises a squared length under linear constraints in three dimensions, by adding one
// constraint after the other: where the new one is violated it is tight, and a problem of one
// dimension less is left. Seidel, "Small-dimensional linear programming and convex hulls made easy"
// (1991).

namespace graze {

using narrowphase::Exit;
using narrowphase::Vec3;

void Clearance::start(double tolerance) {
  exits_.clear();
  translation_ = {};
  tolerance_ = tolerance;
}

bool Clearance::goes_along(const Vec3& x, const Exit& exit) const {
  return dot(x, exit.direction) >= exit.depth;
}

void Clearance::add(const Exit& exit) {
  exits_.push_back({exit.direction, exit.depth + tolerance_});
  if (goes_along(translation_, exits_.back())) return;
  const std::optional<Vec3> found = on_plane(exits_.size() - 1);
  double most = 0;
  for (const Exit& each : exits_)
    most = std::max(most, each.depth);
  if (found && length(*found) <= kMostTimes * most) {
    translation_ = *found;
  } else {
    exits_.pop_back();
  }
}

/// Returns the shortest translation that satisfies the exits up to c, c with equality.
std::optional<Vec3> Clearance::on_plane(std::size_t c) const {
  Vec3 x = exits_[c].direction * exits_[c].depth;
  for (std::size_t i = 0; i < c; ++i) {
    if (goes_along(x, exits_[i])) continue;
    const std::optional<Vec3> on_both = on_line(c, i);
    if (!on_both) return std::nullopt;
    x = *on_both;
  }
  return x;
}

/// Returns the shortest translation that satisfies the exits up to i, and c, these two with
/// equality.
std::optional<Vec3> Clearance::on_line(std::size_t c, std::size_t i) const {
  const Exit &s = exits_[c], &t = exits_[i];
  const Vec3 line = cross(s.direction, t.direction);
  const double square = dot(line, line);
  if (!(square > 0)) return std::nullopt;
  Vec3 x = (cross(t.direction, line) * s.depth + cross(line, s.direction) * t.depth) * (1 / square);
  for (std::size_t j = 0; j < i; ++j) {
    if (goes_along(x, exits_[j])) continue;
    const double rise = dot(line, exits_[j].direction);
    if (rise == 0) return std::nullopt;
    x = x + line * ((exits_[j].depth - dot(x, exits_[j].direction)) / rise);
    for (std::size_t k = 0; k < j; ++k) {
      if (dot(x, exits_[k].direction) < exits_[k].depth - 0.5 * tolerance_) return std::nullopt;
    }
  }
  return x;
}

}  // namespace graze
