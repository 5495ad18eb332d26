// The line is taken from its point nearest to the core's middle, and lengths are relative to the
// core's size: then what is rounded is of the size of the shape, wherever the ray comes from, and
// rounding moves a face by some 10 u of the scale, u = 2^-53. Each part of a shape is met along an
// interval of the line, by a formula that is stable in the sense that its result is exact for a
// part that is moved by so much.

#include <graze/narrowphase/convex/core/core_ray.h>
#include <graze/narrowphase/convex/core/hull_ray.h>
#include <graze/narrowphase/derived/double_pair.h>

#include <algorithm>
#include <limits>

namespace graze::narrowphase {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Directions that turn by less than this over the size of the shape are parallel; it is less than
// kRayTolerance.
constexpr double kParallel = 0x1p-42;

// Nothing is taken to be thinner than this share of its size, so that no ratio of lengths is
// larger than its inverse.
constexpr double kThinnest = 0x1p-50;

/// Holds a line, and the part of it that is within the shape: empty if enter > exit.
struct Line {
  Vec3 origin;
  Vec3 direction;
};

/// Holds the part of a ray that is in some set.
struct Stretch {
  double enter = -kInfinity;
  double exit = kInfinity;
  Vec3 normal;  ///< the set's normal where the ray enters: outward, of any length

  static Stretch nothing() { return {kInfinity, -kInfinity, {}}; }
  bool is_empty() const { return !(enter <= exit); }
};

Vec3 at(const Line& line, double s) {
  return line.origin + line.direction * s;
}

/// Returns what two convex parts have in common.
Stretch common(const Stretch& a, const Stretch& b) {
  Stretch both = a.enter >= b.enter ? a : b;
  both.exit = std::min(a.exit, b.exit);
  return both;
}

/// Joins two parts whose union is convex.
Stretch joined(const Stretch& a, const Stretch& b) {
  if (a.is_empty()) return b;
  if (b.is_empty()) return a;
  Stretch all = a.enter <= b.enter ? a : b;
  all.exit = std::max(a.exit, b.exit);
  return all;
}

/// Returns the line's part with normal . x <= offset.
Stretch in_half_space(const Line& line, const Vec3& normal, double offset) {
  const double room = offset - dot(normal, line.origin);
  const double slope = dot(normal, line.direction);
  const double size = largest(normal) * largest(line.direction);
  if (std::abs(slope) <= 0x1p-52 * size) return room < 0 ? Stretch::nothing() : Stretch{};
  Stretch stretch;
  (slope < 0 ? stretch.enter : stretch.exit) = room / slope;
  stretch.normal = normal;
  return stretch;
}

/// Returns the line's part with -half <= x_k <= half, `unit_axis` being the axis k.
Stretch in_slab(const Line& line, const Vec3& unit_axis, double half) {
  return common(in_half_space(line, unit_axis, half), in_half_space(line, -unit_axis, half));
}

/// Returns the line's part in the ball about 0, for a direction of any length.
Stretch in_ball(const Line& line, double radius) {
  const double square = dot(line.direction, line.direction);
  if (!(square > 0)) return length(line.origin) <= radius ? Stretch{} : Stretch::nothing();
  const double nearest = -dot(line.origin, line.direction) / square;
  const double beside = length(at(line, nearest));
  if (!(beside <= radius)) return Stretch::nothing();
  const double half = std::sqrt((radius - beside) * (radius + beside) / square);
  return {nearest - half, nearest + half, at(line, nearest - half)};
}

Vec3 across(const Vec3& v, const Vec3& unit_axis) {
  return v - unit_axis * dot(v, unit_axis);
}

/// Returns the line's part that is at most the radius from the line through 0 along the axis.
Stretch in_tube(const Line& line, const Vec3& unit_axis, double radius) {
  const Line beside{across(line.origin, unit_axis), across(line.direction, unit_axis)};
  if (length(beside.direction) < kParallel * length(line.direction))
    return length(beside.origin) <= radius ? Stretch{} : Stretch::nothing();
  return in_ball(beside, radius);
}

/// Describes the line from another of its points, `by` further on.
struct Shifted {
  Line line;
  double by;

  /// A part that is empty by less than rounding here may not come out as a point.
  Stretch back(Stretch stretch) const {
    if (stretch.is_empty()) return Stretch::nothing();
    stretch.enter += by;
    stretch.exit += by;
    return stretch;
  }
};

/// Takes the line from where it is at the middle of the axis along which it goes farthest, measured
/// in half lengths. Where a shape is thin along this axis other points of the line are many half
/// lengths away, and so is what is rounded there; here all of the shape is about one unit wide, in
/// units of its half lengths, and what is rounded from now on moves its faces by some u of each of
/// these.
Shifted from_middle_of_steepest(const Line& line, const Vec3& half) {
  constexpr double Vec3::*kAxes[3] = {&Vec3::x, &Vec3::y, &Vec3::z};
  double Vec3::*steepest = kAxes[0];
  double most = -1;
  for (double Vec3::*axis : kAxes) {
    const double along = std::abs(line.direction.*axis) / (half.*axis);
    if (along > most) most = along, steepest = axis;
  }
  const double by = -(line.origin.*steepest) / (line.direction.*steepest);
  Shifted shifted{{at(line, by), line.direction}, by};
  shifted.line.origin.*steepest = 0;
  return shifted;
}

/// Returns the line's stretch in a shape. Where the shape is not thin the line is taken as it is:
/// then what is rounded moves faces by some u times the inverse of kThin.
template <typename InShape>
Stretch in_maybe_thin(const Line& line, const Vec3& half, InShape&& in_shape) {
  constexpr double kThin = 0.015625;
  if (half.x > kThin && half.y > kThin && half.z > kThin) return in_shape(line);
  const Shifted shifted = from_middle_of_steepest(line, half);
  return shifted.back(in_shape(shifted.line));
}

Line moved(const Line& line, const Vec3& by) {
  return {line.origin - by, line.direction};
}

/// Takes away what a normal has along `direction` if it looks along it, as rounding may make it
/// where the line grazes a side. False if that is most of the normal, which then is rounding
/// itself.
bool turn_against(const Vec3& direction, Vec3& normal) {
  const double along = dot(normal, direction);
  if (!(along > 0)) return largest(normal) > 0;
  const double before = dot(normal, normal);
  normal = normal - direction * (along / dot(direction, direction));
  return dot(normal, normal) > 0.5 * before;
}

/// Returns the normal where the line enters: away from the segment, and where its inside is nearest
/// at right angles to it and against the line, however thin the capsule is.
Vec3 capsule_normal(const Line& line, double enter, const Vec3& axis, double half_length) {
  const Vec3 point = at(line, enter);
  const double along = dot(point, axis);
  if (std::abs(along) > half_length) {
    Vec3 of_end = point - axis * (along < 0 ? -half_length : half_length);
    if (turn_against(line.direction, of_end)) return of_end;
  }
  const Vec3 beside = across(line.direction, axis);
  Vec3 of_tube = across(across(point, axis), axis);  // the second call takes away what the first
                                                     // left
  if (length(beside) < kParallel * length(line.direction)) return of_tube;
  return turn_against(beside, of_tube) ? of_tube : -beside;
}

Stretch in_capsule(const Line& line, const Vec3& half_axis, double radius) {
  const Vec3 axis = unit_or(half_axis, {0, 0, 1});
  const double half_length = length(half_axis);
  const Stretch ends =
      joined(in_ball(moved(line, half_axis), radius), in_ball(moved(line, -half_axis), radius));
  const Stretch tube = common(in_tube(line, axis, radius), in_slab(line, axis, half_length));
  Stretch all = joined(ends, tube);
  // The normal is not that of the part that is met first: where parts meet rounding would choose
  // the tube's discs.
  if (!all.is_empty()) all.normal = capsule_normal(line, all.enter, axis, half_length);
  return all;
}

Stretch in_cylinder(const Line& line, const Vec3& half) {
  return common(in_tube(line, {0, 0, 1}, half.x), in_slab(line, {0, 0, 1}, half.z));
}

/// For a direction on or within the cone the line is in the nappe w >= 0 from one point upward.
Stretch upward_from(const Line& line, double s) {
  Stretch stretch;
  if (line.direction.z > 0) {
    const Vec3 point = at(line, s);
    stretch.enter = s;
    stretch.normal = {point.x, point.y, -point.z};
  } else {
    stretch.exit = s;
  }
  return stretch;
}

/// Returns where a line in (x, y, w) has x^2 + y^2 <= w^2 and w >= 0: where a s^2 + 2 b s + c <= 0,
/// on one of two nappes. The coefficients cancel, and so they are computed in twice the precision.
Stretch in_nappe(const Line& line) {
  const Vec3& o = line.origin;
  const Vec3& d = line.direction;
  const auto form = [](const Vec3& p, const Vec3& q) {
    const PairVector pair{{p.x, 0}, {p.y, 0}, {-p.z, 0}};
    return dot(pair, PairVector{{q.x, 0}, {q.y, 0}, {q.z, 0}});
  };
  const DoublePair a = form(d, d), b = form(o, d), c = form(o, o);
  const bool is_upward = d.z > 0;
  if (std::abs(a.high) <= 0x1p-90 * dot(d, d)) {  // along the cone: one point, and on one nappe
    if (b.high == 0) {
      // The line is in the plane that touches the cone along a generator parallel to it: the form
      // is c all along, which is 0 on that generator and above 0 beside it.
      if (c.high > 0x1p-90 * dot(o, o)) return Stretch::nothing();
      return upward_from(line, -o.z / d.z);
    }
    if ((b.high < 0) != is_upward) return Stretch::nothing();
    return upward_from(line, -c.high / (2 * b.high));
  }
  const DoublePair discriminant = b * b - a * c;
  // Only a line that is flatter than the cone can miss both nappes.
  if (discriminant.high < 0 && a.high > 0) return Stretch::nothing();
  const double root = discriminant.high > 0 ? rounded_root(discriminant) : 0;
  const double sum = b.high > 0 ? -(b.high + root) : root - b.high;  // no cancellation
  const double one = sum / a.high;
  const double other = sum == 0 ? one : c.high / sum;
  const double first = std::min(one, other);
  const double second = std::max(one, other);
  if (a.high < 0) return upward_from(line, is_upward ? second : first);
  if (o.z - d.z * (b.high / a.high) < 0) return Stretch::nothing();
  const Vec3 point = at(line, first);
  return {first, second, {point.x, point.y, -point.z}};
}

/// Returns the outward normal at a point of the nappe, in the coordinates of in_nappe(), against
/// the line. At the apex and next to it, where rounding leaves no side, it is that of the side that
/// the line comes from.
Vec3 nappe_normal(const Vec3& point, const Vec3& direction) {
  const auto of_side = [](double x, double y) { return Vec3{x, y, -std::sqrt(x * x + y * y)}; };
  const Vec3 normal = of_side(point.x, point.y);
  if (normal.z < 0 && dot(normal, direction) <= 0) return normal;
  const Vec3 of_near_side = of_side(-direction.x, -direction.y);
  return of_near_side.z < 0 ? of_near_side : Vec3{0, 0, -1};
}

/// Returns the line's part in the cone, which is x^2 + y^2 <= w^2, 0 <= w <= 1 in scaled
/// coordinates.
Stretch in_cone(const Line& line, const Vec3& half) {
  const auto scaled = [&](const Vec3& v, double w) {
    return Vec3{v.x / half.x, v.y / half.x, (w - v.z) / (2 * half.z)};
  };
  const Line own{scaled(line.origin, half.z), scaled(line.direction, 0)};
  Stretch side = in_nappe(own);
  if (side.is_empty()) return Stretch::nothing();
  side.normal = nappe_normal(side.normal, own.direction);
  side.normal = {side.normal.x / half.x, side.normal.y / half.x, -side.normal.z / (2 * half.z)};
  return common(side, in_slab(line, {0, 0, 1}, half.z));
}

Stretch in_ellipsoid(const Line& line, const Vec3& semi) {
  const auto scaled = [&](const Vec3& v) { return Vec3{v.x / semi.x, v.y / semi.y, v.z / semi.z}; };
  Stretch stretch = in_ball({scaled(line.origin), scaled(line.direction)}, 1);
  stretch.normal = scaled(stretch.normal);
  return stretch;
}

Stretch in_box(const Line& line, const Vec3& half) {
  return common(common(in_slab(line, {1, 0, 0}, half.x), in_slab(line, {0, 1, 0}, half.y)),
                in_slab(line, {0, 0, 1}, half.z));
}

/// Takes vectors from the common frame into the core's own, by the inverse of its axes, which are
/// not quite orthonormal.
class IntoOwn {
 public:
  explicit IntoOwn(const Core& core) {
    const Vec3* axis = core.axis;
    const Vec3 across_x = cross(axis[1], axis[2]);
    const double volume = dot(axis[0], across_x);
    row_[0] = across_x * (1 / volume);
    row_[1] = cross(axis[2], axis[0]) * (1 / volume);
    row_[2] = cross(axis[0], axis[1]) * (1 / volume);
  }
  Vec3 operator()(const Vec3& v) const {
    return {dot(row_[0], v), dot(row_[1], v), dot(row_[2], v)};
  }
  /// Takes a normal back, by the transpose.
  Vec3 normal_back(const Vec3& n) const { return (row_[0] * n.x + row_[1] * n.y) + row_[2] * n.z; }

 private:
  Vec3 row_[3];
};

Vec3 thick(const Vec3& half, double size) {
  const auto limited = [&](double h) { return std::max(h / size, kThinnest); };
  return {limited(half.x), limited(half.y), limited(half.z)};
}

Stretch in_own(const Core& core, const Line& line, double size) {
  const Vec3 half = thick(core.half, size);
  switch (core.kind) {
    case CoreKind::Box:
      return in_box(line, half);
    case CoreKind::Cylinder:
      return in_cylinder(line, half);
    case CoreKind::Cone:
      return in_maybe_thin(line, {half.x, half.x, half.z},
                           [&](const Line& near) { return in_cone(near, half); });
    case CoreKind::Ellipsoid:
      return in_maybe_thin(line, half, [&](const Line& near) { return in_ellipsoid(near, half); });
    default:
      return Stretch::nothing();
  }
}

/// Returns the line's stretch in units of the size; its origin is relative to the core's middle.
Stretch in_core(const Core& core, const Line& line, double size) {
  if (core.kind == CoreKind::Point) return in_ball(line, core.radius / size);
  if (core.kind == CoreKind::Segment)
    return in_capsule(line, core.axis[2] * (core.half.z / size), core.radius / size);
  const IntoOwn into_own(core);
  Stretch stretch = in_own(core, {into_own(line.origin), into_own(line.direction)}, size);
  stretch.normal = into_own.normal_back(stretch.normal);
  return stretch;
}

/// Returns the normal with length 1, and against the ray in spite of what rounding makes of one
/// that is at right angles to it.
Vec3 unit_against(const Vec3& normal, const Vec3& direction) {
  const Vec3 unit = unit_or(normal, -direction);
  const double along = dot(unit, direction);
  return along > 0 ? unit_or(unit - direction * (along + 0x1p-52), -direction) : unit;
}

/// Casts at a hull. Its faces may meet at any angle, so that planes that are elsewhere by however
/// little may meet far away. So it is the ray that is moved, by rounding, and what it meets is
/// exact. From near the hull the ray begins where it does, from afar at its point nearest to the
/// middle.
std::optional<CoreRayHit> cast_at_hull(const Core& core, const Vec3& from_middle,
                                       const Vec3& direction) {
  const double far = largest(from_middle);
  const IntoOwn into_own(core);
  const auto placed = [&](const HullRayHit& hit, double before) {
    const double distance = before + hit.distance;
    if (!(distance > 0)) return CoreRayHit{0, -direction};
    return CoreRayHit{distance, unit_against(into_own.normal_back(hit.normal), direction)};
  };
  const Vec3 along = into_own(direction);
  if (far <= 4 * core.bounding_radius) {
    const auto hit = cast_ray(*core.hull, into_own(from_middle), along, HullRayStart::Here);
    return hit ? std::optional(placed(*hit, 0)) : std::nullopt;
  }
  const Vec3 start{from_middle.x / far, from_middle.y / far, from_middle.z / far};
  const double to_nearest = -dot(start, direction);
  const Vec3 nearest = (start + direction * to_nearest) * far;
  if (!(to_nearest > 0) || !(largest(nearest) <= 2 * core.bounding_radius)) return std::nullopt;
  const auto hit = cast_ray(*core.hull, into_own(nearest), along, HullRayStart::FarBehind);
  return hit ? std::optional(placed(*hit, to_nearest * far)) : std::nullopt;
}

}  // namespace

std::optional<CoreRayHit> cast_ray(const Core& core, const Vec3& origin, const Vec3& direction) {
  const double size = core.bounding_radius + core.radius;
  const Vec3 from_middle = origin - core.at;
  if (core.kind == CoreKind::Points) return cast_at_hull(core, from_middle, direction);
  // Lengths are in units of whichever is larger, so that nothing overflows in between.
  const double far = std::max(largest(from_middle), size);
  const Vec3 start{from_middle.x / far, from_middle.y / far, from_middle.z / far};
  const double to_nearest = -dot(start, direction);
  const Vec3 nearest = start + direction * to_nearest;
  const double beside = length(nearest) * (far / size);
  if (!(beside <= 2)) return std::nullopt;
  const Stretch stretch = in_core(core, {nearest * (far / size), direction}, size);
  if (stretch.is_empty()) return std::nullopt;
  // The ray begins at -to_nearest on this line.
  const double enter = to_nearest * far + stretch.enter * size;
  const double exit = to_nearest * far + stretch.exit * size;
  if (exit < 0) return std::nullopt;
  if (!(enter > 0)) return CoreRayHit{0, -direction};
  return CoreRayHit{enter, unit_against(stretch.normal, direction)};
}

}  // namespace graze::narrowphase
