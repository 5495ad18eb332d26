#include <graze/engine/world/contacts/local_parting.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {

using narrowphase::Core;
using narrowphase::CornerExits;
using narrowphase::DirectionArc;
using narrowphase::Exit;
using narrowphase::Vec3;

namespace {

// Of exits that are equally long to this share, the one of the larger feature is taken.
constexpr double kSameDepth = 1e-9;

// An exit is surely too long if its bound is too long by this many times the length below which
// exits count as equal.
constexpr double kSureTimes = 4;

/// Returns the least of `along` cos(p) + `within` sin(p) over the angles p of an arc. Between its
/// ends the sum is least where it is minus its amplitude: there, if it falls at the beginning of
/// the arc and rises at the end.
double least_of(double along, double within, const DirectionArc& arc) {
  if (within < 0 && within * arc.cosine > along * arc.sine) return -std::hypot(along, within);
  return std::min(along, along * arc.cosine + within * arc.sine);
}

}  // namespace

Vec3 LocalPartings::normal_of(const Core& triangle) {
  const Vec3* corner = triangle.corner;
  return unit_or(cross(corner[1] - corner[0], corner[2] - corner[0]), {0, 0, 1});
}

LocalParting LocalPartings::of(std::uint32_t index, const Core& triangle) const {
  const Vec3 normal = normal_of(triangle);
  return of(index, triangle, normal, support(core_, -normal));
}

LocalParting LocalPartings::of(std::uint32_t index, const Core& triangle, const Vec3& normal,
                               const Vec3& deepest) const {
  constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  return below(kUnbounded, index, triangle, normal, deepest)
      .value_or(LocalParting{index, {normal, kUnbounded}});
}

std::optional<LocalParting> LocalPartings::below(double limit, std::uint32_t index,
                                                 const Core& triangle, const Vec3& normal,
                                                 const Vec3& deepest) const {
  LocalParting least{index, {normal, dot(normal, triangle.corner[0] - deepest) + core_.radius}};
  // With t the depth, r how far within an edge the deepest point is and p the angle of a direction
  // to the normal, the exit along it is at least t cos(p) + r sin(p): no less than t up to 127
  // degrees if r is 2 t. Corners lie beyond two edges.
  const double face_depth = least.exit.depth;
  const double enough = 2 * face_depth;
  double within[3];
  for (int k = 0; k < 3; ++k) {
    const Vec3 along = triangle.corner[(k + 1) % 3] - triangle.corner[k];
    within[k] = dot(unit_or(cross(along, normal), normal), triangle.corner[k] - deepest);
  }
  const double same = kSameDepth * (core_.bounding_radius + core_.radius);
  // Exits that are nearly as short as one below the limit influence which one is taken.
  const double too_long = limit + kSureTimes * same;
  bool is_complete = true;
  // Returns the length below which an exit is shorter than the best so far, by its share.
  const auto shorter = [&] {
    const double depth = least.exit.depth;
    if (least.feature != LeftFeature::Face) return depth;
    return settings_.margin + settings_.face_share * (depth - settings_.margin);
  };
  // True if an exit of that depth is taken rather than the best so far.
  bool is_close = false;
  const auto beats = [&](double depth) {
    if (depth < shorter() - same) return true;
    is_close |= depth < least.exit.depth - same;
    return false;
  };
  const auto offer = [&](const Exit& exit, LeftFeature feature, int which) {
    if (beats(exit.depth)) least = {index, exit, feature, which};
  };
  for (int k = 0; k < 3; ++k) {
    if (within[k] >= enough) continue;
    const std::optional<DirectionArc> arc = features_.arc(index, k, triangle, normal);
    if (!arc) continue;
    // The deepest point alone gives a lower bound.
    const double at_least = core_.radius + least_of(face_depth - core_.radius, within[k], *arc);
    if (!beats(at_least)) continue;
    Exit exit{{}, at_least};
    if (at_least < too_long)
      exit = least_on_arc(core_, triangle.corner[k], *arc, deepest, too_long);
    if (exit.depth < too_long) {
      offer(exit, LeftFeature::Edge, k);
    } else {
      is_complete = false;
    }
  }
  for (int k = 0; k < 3; ++k) {
    if (std::min(within[k], within[(k + 2) % 3]) >= enough) continue;
    CornerExits exits(core_, triangle.corner[k]);
    // A share of a negative depth is more than the depth.
    const auto limit_of_any = [&] { return std::max(shorter(), least.exit.depth) - same; };
    while (const std::optional<Exit> exit = exits.next(limit_of_any())) {
      if (!beats(exit->depth)) continue;
      // The corner of a flat face has nothing ahead of it behind the face, either.
      if (dot(exit->direction, normal) > 0 && features_.corner_faces(index, k, exit->direction))
        offer(*exit, LeftFeature::Corner, k);
    }
  }
  if (!is_complete && !(least.exit.depth < limit)) return std::nullopt;
  least.is_close = is_close;
  return least;
}

}  // namespace graze
