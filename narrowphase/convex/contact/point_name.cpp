#include <graze/narrowphase/convex/contact/meeting_points.h>
#include <graze/narrowphase/convex/contact/point_name.h>

#include <cmath>

namespace graze::narrowphase {
namespace {

// A turn has so many parts, as divided by share_of_turn(); 512 parts are of 0.9 degrees at most.
constexpr std::uint64_t kParts = 8, kNarrowParts = 512;

// The first part ends at this share of a turn: nothing that is turned by quarters or eighths is
// near where one part ends.
constexpr double kFirstEnd = 0.0345;

// About the axis itself, to half a degree, no part looks along a direction more than another.
constexpr double kAboutAxis = 0.01;

// Sides are sharp where their radii exceed the depth by less than this share of the smaller size.
constexpr double kSharp = 0x1p-6;

bool has_round_side(const Core& core) {
  return core.kind == CoreKind::Cylinder || core.kind == CoreKind::Cone;
}

/// Returns how far a point is from the axis of a round side, and 0 for all other sets.
double radius_at(const Core& core, const Vec3& point) {
  if (!has_round_side(core)) return 0;
  const Vec3 off = point - core.at;
  return length(off - core.axis[2] * dot(off, core.axis[2]));
}

/// Returns a share that grows from 0 to 1 about the axis, by as much in each quarter. It needs no C
/// library, and so grows up to twice as fast at some angles as at others.
double share_of_turn(double x, double y) {
  const double of_quarters = y / (std::abs(x) + std::abs(y));
  if (x < 0) return 0.25 * (2 - of_quarters);
  return 0.25 * (of_quarters < 0 ? 4 + of_quarters : of_quarters);
}

/// Returns the part of a round side that looks along a direction; 0 for sets without one.
std::uint64_t part_along(const Core& core, const Vec3& out, bool is_sharp) {
  if (!has_round_side(core)) return 0;
  const double x = dot(out, core.axis[0]), y = dot(out, core.axis[1]);
  if (x * x + y * y < kAboutAxis * kAboutAxis) return 1 + kParts + kNarrowParts;
  const double turn = share_of_turn(x, y) + kFirstEnd;
  const std::uint64_t parts = is_sharp ? kNarrowParts : kParts;
  const auto part =
      static_cast<std::uint64_t>((turn - std::floor(turn)) * static_cast<double>(parts));
  return 1 + (is_sharp ? kParts : 0) + part;
}

}  // namespace

void name_point(const Core& a, const Core& b, ContactPoint& contact) {
  const double radii = radius_at(a, contact.point_a) + radius_at(b, contact.point_b);
  const bool is_sharp = radii - contact.depth < kSharp * smaller_size(a, b);
  contact.feature_a = part_along(a, contact.normal, is_sharp) << 32 | kPointFeature;
  contact.feature_b = part_along(b, -contact.normal, is_sharp) << 32 | kPointFeature;
}

}  // namespace graze::narrowphase
