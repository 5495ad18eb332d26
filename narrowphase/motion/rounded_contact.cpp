// Most paths never have all four points in one plane, or have the point outside of the triangle
// while they do, by far: signs of coefficients in Bernstein's basis show it, for a polynomial is
// between its coefficients there (Farouki and Rajan, "On the numerical condition of polynomials in
// Bernstein form", Computer Aided Geometric Design 4, 1987). Time is halved where they do not.
//
// Below, u = 2^-53. An offset at a time t of 2^-53 times an integer is (1 - t) d_0 + t d_1, of
// rounded differences at both ends, which are off by u X and at most X in size: two products and
// one sum make that 3 u X (1 + u)^2. X, Y, Z are the largest offsets, rounded.

#include <graze/narrowphase/motion/rounded_contact.h>
#include <cmath>

namespace graze::narrowphase {
namespace {

// A coefficient in the middle of the volume has 18 monomials. Each is off by 9.01 u X Y Z from
// three offsets, and by seven roundings at most: two products, the cross product's difference, the
// sum of two of them, two sums of the dot product, the sum of two of these. 18 * 16.01 u, and X Y Z
// as it is computed is less than the exact product by 5 u: 288.3 u. Coefficients at the ends have
// 6 monomials.
constexpr double kVolumeBound = 300 * 0x1p-53;

// The areas of a projection have two monomials at the ends and four in the middle, each off by
// 6.01 u X Y from two offsets and three roundings: 36.1 u X Y. The third weight is a difference of
// three such, with two roundings of at most 8 X Y and 12 X Y: 128.3 u X Y. Beside it the rounding
// of X Y is nothing.
constexpr double kAreaBound = 136 * 0x1p-53;

// Within these no product of three offsets overflows, nor a sum of 18; and what underflow takes,
// 2^-1074, is 2^-474 of the least volume, far below its bound.
constexpr double kSmallestExtent = 0x1p-200;
constexpr double kLargestExtent = 0x1p+250;

// Times are multiples of 2^-20, where a stretch ends before 1, halved so often: 1 - t is exact.
constexpr int kMostHalvings = 24;
constexpr int kMostStretches = 96;

double largest(TwoLanes a, TwoLanes b, TwoLanes c) {
  const TwoLanes both_ends = larger(larger(magnitude(a), magnitude(b)), magnitude(c));
  return larger(both_ends, swapped(both_ends))[0];
}

/// True if one set is beyond the other along an axis at both ends, so that it is so throughout,
/// exactly.
bool are_apart(TwoLanes p, TwoLanes q, TwoLanes r, TwoLanes s, PathPair kind) {
  TwoLanes low_a = p, high_a = p, low_b = smaller(r, s), high_b = larger(r, s);
  if (kind == PathPair::PointTriangle) {
    low_b = smaller(low_b, q);
    high_b = larger(high_b, q);
  } else {
    low_a = smaller(p, q);
    high_a = larger(p, q);
  }
  return sign_bits(are_greater(low_a, high_b)) == 0b11 ||
         sign_bits(are_greater(low_b, high_a)) == 0b11;
}

/// Holds the largest offsets in each axis, at both ends of time.
struct PathExtents {
  double x;
  double y;
  double z;
};

/// Returns 0 for 0, as a set without extent has no area.
double safe_inverse(double value) {
  return value == 0 ? 0 : 1 / value;
}

bool is_in_range(double extent) {
  return extent >= kSmallestExtent && extent <= kLargestExtent;
}

enum class CoefficientSigns { AllPositive, AllNegative, Mixed };

/// A polynomial of degree two, by its coefficients at the ends, and twice that in the middle.
struct AreaLanes {
  TwoLanes ends;
  double middle;

  CoefficientSigns signs(double bound) const {
    if (ends[0] > bound && ends[1] > bound && middle > bound) return CoefficientSigns::AllPositive;
    if (ends[0] < -bound && ends[1] < -bound && middle < -bound)
      return CoefficientSigns::AllNegative;
    return CoefficientSigns::Mixed;
  }
};

AreaLanes operator-(const AreaLanes& a, const AreaLanes& b) {
  return {a.ends - b.ends, a.middle - b.middle};
}

AreaLanes negated(const AreaLanes& a) {
  return {-a.ends, -a.middle};
}

/// Returns a x b as seen along an axis, whose other two coordinates are given as the first and the
/// second.
AreaLanes area(TwoLanes a_first, TwoLanes a_second, TwoLanes b_first, TwoLanes b_second) {
  const TwoLanes mixed = a_first * swapped(b_second) - a_second * swapped(b_first);
  return {a_first * b_second - a_second * b_first, mixed[0] + mixed[1]};
}

TwoLanes component(const TwoVectors& v, int axis) {
  return axis == 0 ? v.x : (axis == 1 ? v.y : v.z);
}

/// Says where a time is at which all points are in one plane, if there is one in a stretch.
enum class Place { Inside, Outside, Unsure };

/// True if all coefficients have one sign.
bool is_never_flat(const VolumeLanes& volume, double bound) {
  const TwoLanes limit = both(bound);
  const TwoLanes above =
      both_of(are_greater(volume.ends, limit), are_greater(volume.middle, limit));
  const TwoLanes below =
      both_of(are_greater(-limit, volume.ends), are_greater(-limit, volume.middle));
  return sign_bits(above) == 0b11 || sign_bits(below) == 0b11;
}

class Search {
 public:
  Search(const OffsetLanes& offsets, PathPair kind, const PathExtents& extents, double volume_bound)
      : whole_(offsets),
        kind_(kind),
        extent_{extents.x, extents.y, extents.z},
        scale_{safe_inverse(extents.y * extents.z), safe_inverse(extents.z * extents.x),
               safe_inverse(extents.x * extents.y)},
        volume_bound_(volume_bound) {}

  RoundedAnswer run(const VolumeLanes& volume, double until) {
    RoundedAnswer answer{RoundedContact::None, 0, 1};
    // The end is the least multiple of 2^-20 above, so that it is a time of few bits.
    const double end = std::floor(until * 0x1p20 + 1) * 0x1p-20;
    if (end >= 1) {
      look(whole_, volume, 0, 1, 0, answer);
    } else {
      const OffsetLanes part = between(0, end);
      look(part, VolumeLanes(part), 0, end, 0, answer);
    }
    return answer;
  }

 private:
  /// True if a contact in this stretch is found or cannot be ruled out: then `answer` says so.
  bool look(const OffsetLanes& offsets, const VolumeLanes& volume, double low, double high,
            int halvings, RoundedAnswer& answer) {
    if (is_never_flat(volume, volume_bound_)) return false;
    const Place place = place_of(offsets);
    if (place == Place::Outside) return false;
    if (place == Place::Inside && has_one_root(volume)) {
      answer = {RoundedContact::Root, low, high};
      return true;
    }
    if (halvings == kMostHalvings || ++stretches_ > kMostStretches) {
      answer = {RoundedContact::Unsure, low, 1};
      return true;
    }
    const double middle = (low + high) / 2;
    const OffsetLanes first = between(low, middle), second = between(middle, high);
    return look(first, VolumeLanes(first), low, middle, halvings + 1, answer) ||
           look(second, VolumeLanes(second), middle, high, halvings + 1, answer);
  }

  /// True if the signs at the ends are sure and differ, and there is one change of sign in all. It
  /// is sure if one of the two in the middle is sure, and the other between it and an end that has
  /// its sign or not.
  bool has_one_root(const VolumeLanes& volume) const {
    const double first = volume.ends[0], last = volume.ends[1];
    const double second = volume.middle[0], third = volume.middle[1];
    const bool is_rising = first < 0;
    if (is_rising ? !(first < -volume_bound_ && last > volume_bound_)
                  : !(first > volume_bound_ && last < -volume_bound_))
      return false;
    // For two changes more, the second must have the sign of the last and the third that of the
    // first.
    const double up = is_rising ? 1 : -1;
    return up * second < -volume_bound_ || up * third > volume_bound_;
  }

  Place place_of(const OffsetLanes& o) const {
    const TwoVectors normal = cross(o.u, o.v);
    const TwoVectors sum = normal + swapped(normal);
    // The axis is that along which the plane leans least, in units of the extents.
    const double size[3] = {std::abs(sum.x[0]) * scale_[0], std::abs(sum.y[0]) * scale_[1],
                            std::abs(sum.z[0]) * scale_[2]};
    const int axis = size[0] > size[1] ? (size[0] > size[2] ? 0 : 2) : (size[1] > size[2] ? 1 : 2);
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    const double bound = kAreaBound * (extent_[next] * extent_[last]);
    const TwoLanes u1 = component(o.u, next), u2 = component(o.u, last);
    const TwoLanes v1 = component(o.v, next), v2 = component(o.v, last);
    const TwoLanes w1 = component(o.w, next), w2 = component(o.w, last);
    AreaLanes whole = area(u1, u2, v1, v2);
    const CoefficientSigns turn = whole.signs(bound);
    if (turn == CoefficientSigns::Mixed) return Place::Unsure;
    AreaLanes along_u = area(w1, w2, v1, v2), along_v = area(u1, u2, w1, w2);
    if (turn == CoefficientSigns::AllNegative) {
      whole = negated(whole);
      along_u = negated(along_u);
      along_v = negated(along_v);
    }
    if (kind_ == PathPair::PointTriangle)
      return common(along_u, along_v, whole - along_u - along_v, bound);
    along_v = negated(along_v);
    const Place place = common(along_u, whole - along_u, along_v, bound);
    if (place == Place::Outside) return place;
    const CoefficientSigns rest = (whole - along_v).signs(bound);
    if (rest == CoefficientSigns::AllNegative) return Place::Outside;
    return rest == CoefficientSigns::AllPositive ? place : Place::Unsure;
  }

  static Place common(const AreaLanes& a, const AreaLanes& b, const AreaLanes& c, double bound) {
    const CoefficientSigns of_a = a.signs(bound), of_b = b.signs(bound), of_c = c.signs(bound);
    if (of_a == CoefficientSigns::AllNegative || of_b == CoefficientSigns::AllNegative ||
        of_c == CoefficientSigns::AllNegative)
      return Place::Outside;
    return of_a == CoefficientSigns::AllPositive && of_b == of_a && of_c == of_a ? Place::Inside
                                                                                 : Place::Unsure;
  }

  OffsetLanes between(double low, double high) const {
    const TwoLanes t{low, high}, s{1 - low, 1 - high};
    const auto at = [&](TwoLanes ends) { return both(ends[0]) * s + both(ends[1]) * t; };
    const auto vector_at = [&](const TwoVectors& ends) {
      return TwoVectors{at(ends.x), at(ends.y), at(ends.z)};
    };
    OffsetLanes result;
    result.u = vector_at(whole_.u);
    result.v = vector_at(whole_.v);
    result.w = vector_at(whole_.w);
    return result;
  }

  const OffsetLanes& whole_;
  PathPair kind_;
  double extent_[3];
  double scale_[3];  ///< 1 over the extents of a projection along each axis
  double volume_bound_;
  int stretches_ = 0;
};

}  // namespace

PathLanes PathLanes::in_own_units() const {
  PathLanes result = *this;
  for (TwoLanes TwoVectors::*axis : {&TwoVectors::x, &TwoVectors::y, &TwoVectors::z}) {
    double most = 0;
    for (const TwoVectors& p : point)
      most = std::fmax(most, std::fmax(std::abs((p.*axis)[0]), std::abs((p.*axis)[1])));
    if (most == 0) continue;
    const int exponent = std::ilogb(most);
    for (TwoVectors& p : result.point)
      p.*axis = TwoLanes{std::ldexp((p.*axis)[0], -exponent), std::ldexp((p.*axis)[1], -exponent)};
  }
  return result;
}

RoundedAnswer rounded_contact(const PathLanes& lanes, PathPair kind, double until) {
  const TwoVectors* p = lanes.point;
  if (are_apart(p[0].x, p[1].x, p[2].x, p[3].x, kind) ||
      are_apart(p[0].y, p[1].y, p[2].y, p[3].y, kind) ||
      are_apart(p[0].z, p[1].z, p[2].z, p[3].z, kind))
    return {RoundedContact::None};
  const OffsetLanes offsets(lanes, kind);
  const PathExtents extents{largest(offsets.u.x, offsets.v.x, offsets.w.x),
                            largest(offsets.u.y, offsets.v.y, offsets.w.y),
                            largest(offsets.u.z, offsets.v.z, offsets.w.z)};
  // If all is in a plane across an axis it is flat, and areas along that axis may still tell.
  const int in_range = is_in_range(extents.x) + is_in_range(extents.y) + is_in_range(extents.z);
  const bool is_across = extents.x == 0 || extents.y == 0 || extents.z == 0;
  if (in_range < (is_across ? 2 : 3)) return {RoundedContact::OutOfRange};
  const VolumeLanes volume(offsets);
  const double bound = kVolumeBound * (extents.x * extents.y * extents.z);
  if (is_never_flat(volume, bound)) return {RoundedContact::None};
  return Search(offsets, kind, extents, bound).run(volume, until);
}

}  // namespace graze::narrowphase
