// Rounds the first contact, known to be the one time of a stretch at which all are in one plane,
// down to a double: Newton's method finds it, and numbers of twice the precision tell the signs at
// the double and at the next one.

#include <graze/narrowphase/derived/double_pair.h>
#include <graze/narrowphase/motion/roots.h>
#include <graze/narrowphase/motion/rounded_contact.h>
#include <cmath>

namespace graze::narrowphase {
namespace {

// The offsets are exact pairs. The value at t is a sum of monomials, 6 (s + t)^3 = 6 of them by
// their weights, each within X Y Z, the product of the largest offsets, and off by fourteen
// operations: two products of offsets, the difference of a cross product, the sum of two of these,
// two sums of a dot product and the sum of two of those; then a product by a power of t that takes
// two more, and five sums and products of Horner's scheme. 6 * 14.01 roundoffs of pairs.
constexpr double kValueBound = 85 * kPairRoundoff;

/// Holds the volume in Bernstein's basis on all of time, the coefficients in the middle times
/// three.
class PairVolume {
 public:
  PairVolume(const PathLanes& lanes, PathPair kind) {
    const bool is_edges = kind == PathPair::EdgeEdge;
    const int from[3] = {is_edges ? 0 : 1, is_edges ? 2 : 1, is_edges ? 0 : 1};
    const int to[3] = {is_edges ? 1 : 2, 3, is_edges ? 2 : 0};
    PairVector start[3], end[3];
    for (int i = 0; i < 3; ++i) {
      const TwoVectors &p = lanes.point[from[i]], &q = lanes.point[to[i]];
      start[i] = offset(p, q, 0);
      end[i] = offset(p, q, 1);
    }
    const PairVector first = cross(start[0], start[1]), last = cross(end[0], end[1]);
    const PairVector between = cross(start[0], end[1]) + cross(end[0], start[1]);
    c_[0] = dot(first, start[2]);
    c_[1] = dot(first, end[2]) + dot(between, start[2]);
    c_[2] = dot(last, start[2]) + dot(between, end[2]);
    c_[3] = dot(last, end[2]);
    double x = 0, y = 0, z = 0;
    for (int i = 0; i < 3; ++i) {
      x = std::fmax(x, std::fmax(std::abs(start[i].x.high), std::abs(end[i].x.high)));
      y = std::fmax(y, std::fmax(std::abs(start[i].y.high), std::abs(end[i].y.high)));
      z = std::fmax(z, std::fmax(std::abs(start[i].z.high), std::abs(end[i].z.high)));
    }
    bound_ = kValueBound * (x * y * z);
  }

  DoublePair value_at(double t) const {
    const DoublePair s = exact_difference(1, t);
    const RoundedPair square = two_product(t, t);
    const DoublePair tt{square.value, square.error};
    return ((c_[0] * s + c_[1] * t) * s + c_[2] * tt) * s + c_[3] * (tt * t);
  }

  /// Returns the sign at t, or Zero if it is not sure.
  Sign sign_at(double t) const {
    const double value = value_at(t).high;
    if (value > bound_) return Sign::Positive;
    return value < -bound_ ? Sign::Negative : Sign::Zero;
  }

  double rough_value_at(double t) const {
    const double s = 1 - t;
    return ((c_[0].high * s + c_[1].high * t) * s + c_[2].high * t * t) * s +
           c_[3].high * t * t * t;
  }

  double rough_slope_at(double t) const {
    const double s = 1 - t;
    return (c_[1].high - 3 * c_[0].high) * s * s + 2 * (c_[2].high - c_[1].high) * s * t +
           (3 * c_[3].high - c_[2].high) * t * t;
  }

 private:
  static PairVector offset(const TwoVectors& from, const TwoVectors& to, int lane) {
    return {exact_difference(to.x[lane], from.x[lane]), exact_difference(to.y[lane], from.y[lane]),
            exact_difference(to.z[lane], from.z[lane])};
  }

  DoublePair c_[4];
  double bound_;
};

/// Finds the root roughly by Newton's method, within a stretch that halving keeps.
double rough_root(const PairVolume& volume, double low, double high) {
  constexpr int kMostSteps = 60;
  const bool is_rising = volume.rough_value_at(high) > 0;
  double t = (low + high) / 2;
  for (int step = 0; step < kMostSteps; ++step) {
    const double value = volume.rough_value_at(t);
    if (value == 0) return t;
    ((value > 0) == is_rising ? high : low) = t;
    double next = t - value / volume.rough_slope_at(t);
    if (!(next > low && next < high)) next = (low + high) / 2;
    if (std::abs(next - t) <= 0x1p-50 * t) return next;
    t = next;
  }
  return t;
}

}  // namespace

std::optional<double> root_rounded_down(const PathLanes& lanes, PathPair kind,
                                        const RoundedAnswer& answer) {
  const PairVolume volume(lanes, kind);
  const double rough = rough_root(volume, answer.low, answer.high);
  const double step = -volume.value_at(rough).high / volume.rough_slope_at(rough);
  const RoundedPair root = two_sum(rough, step);
  const double time = root.error < 0 ? previous_double(root.value) : root.value;
  if (!(time >= answer.low && time < answer.high)) return std::nullopt;
  const Sign before = volume.sign_at(time), after = volume.sign_at(next_double(time));
  if (before == Sign::Zero || after == Sign::Zero || before == after) return std::nullopt;
  return time;
}

double root_rounded_down_exactly(const FourPaths& paths, const RoundedAnswer& answer) {
  const Polynomial volume = volume_of(ExactPaths(paths), paths.kind);
  Root<BigInteger> root{
      volume, {Dyadic<BigInteger>(answer.low), Dyadic<BigInteger>(answer.high), 1, false}};
  narrow(root);
  return root.place.low.floor;
}

}  // namespace graze::narrowphase
