#include <graze/narrowphase/convex/gap/ball_gap.h>
#include <graze/narrowphase/derived/double_pair.h>

#include <algorithm>
#include <cmath>
#include <limits>

// Weights of the corners are guessed, and two bounds proved whatever the guess: a point with any
// weights is in the triangle, and any direction has a plane across it before all corners.
//
// All is in a unit, a power of two, in which the corners seen from the centre, V_i, and the radius
// r are at most 1. w is kPairRoundoff.
//
// From above: the point q = sum w_i V_i / W, W = sum w_i, each w_i >= 0 taken as it is. Each
// product is off by w, the sums of three by 2 w each, the quotient by w: no component is off by
// more than 6.1 w, and |q| not by more than 11 w. q.q is off by 3.1 w of itself, r r by w, their
// difference by w: over |q| + r, which is at least the root of either, that is below 4.1 w |q| + 2
// w r, |q| <= sqrt(3). Together below 21 w.
//
// From below: s = min V_i . q for any q taken as it is. A product is off by w, a sum of three by 2
// w of the sum of their sizes, at most sqrt(3) |q|: 5.3 w |q| in all, of s / |q| 5.3 w. Its square
// and q.q are off by 5.2 w of themselves, the quotient by w, which the root halves: 3.2 w sqrt(3).
// With what the difference takes, as above, below 19 w.
//
// Sums, roots and quotients of high parts round four times: 2^-50 of the result covers them. What
// underflows is below 2^-1000, as no product has more than four factors that are not near 1.

namespace graze::narrowphase {
namespace {

constexpr double kBound = 32 * kPairRoundoff;
constexpr double kRounding = 0x1p-50;

// Normals of unit edges that are shorter than this are rounding.
constexpr double kThinnest = 0x1p-80;

/// What is left of lengths that are next to nothing may be off by some of these.
constexpr double kLeast = 8 * std::numeric_limits<double>::denorm_min();

/// Returns the exponent that brings the largest of some lengths to between 1/2 and 1; 0 if all are
/// 0.
int exponent_of(double largest_length) {
  int exponent = 0;
  if (largest_length > 0) std::frexp(largest_length, &exponent);
  return exponent;
}

PairVector scaled(const PairVector& a, int exponent) {
  const auto times = [&](const DoublePair& x) {
    return DoublePair{std::ldexp(x.high, exponent), std::ldexp(x.low, exponent)};
  };
  return {times(a.x), times(a.y), times(a.z)};
}

PairVector in_units(const PairVector& a) {
  return scaled(a, -exponent_of(largest_component(a)));
}

PairVector operator/(const PairVector& a, const DoublePair& b) {
  return {a.x / b, a.y / b, a.z / b};
}

bool is_less(const DoublePair& a, const DoublePair& b) {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}

Vec3 rounded(const PairVector& a) {
  return {a.x.high, a.y.high, a.z.high};
}

class BallSearch {
 public:
  BallSearch(const Sphere& ball, const Triangle& triangle) : ball_(ball) {
    const double* corner[3] = {triangle.a.data(), triangle.b.data(), triangle.c.data()};
    double largest_length = ball.radius;
    for (int i = 0; i < 3; ++i) {
      corner_[i] = PairVector::difference(corner[i], ball.centre.data());
      edge_[i] = in_units(PairVector::difference(corner[(i + 1) % 3], corner[i]));
      largest_length = std::max(largest_length, largest_component(corner_[i]));
    }
    exponent_ = exponent_of(largest_length);
    for (PairVector& c : corner_)
      c = scaled(c, -exponent_);
    radius_ = std::ldexp(ball.radius, -exponent_);
  }

  BallGap run() {
    try_face();
    for (int i = 0; i < 3; ++i)
      try_edge(i);
    offer_plane(nearest_);
    const double from_above = std::ldexp(beyond(square_), exponent_);
    const Vec3 to_point = rounded(scaled(nearest_, exponent_));
    const double from_below = has_plane_ ? std::ldexp(beyond(most_), exponent_) : -ball_.radius;
    const double off = std::max(std::ldexp(kBound, exponent_), kLeast);
    return {from_below - (kRounding * std::abs(from_below) + off),
            from_above + (kRounding * std::abs(from_above) + off), to_point, normal_};
  }

 private:
  /// Tries the foot on the plane, if it is inside, with the areas that it makes as weights.
  void try_face() {
    const PairVector normal = cross(edge_[0], edge_[1]);
    if (!(largest_component(normal) >= kThinnest)) return;
    DoublePair weight[3];
    for (int i = 0; i < 3; ++i) {
      weight[i] = dot(cross(corner_[(i + 1) % 3], corner_[(i + 2) % 3]), normal);
      if (!(weight[i].high > 0)) return;
    }
    const DoublePair sum = weight[0] + weight[1] + weight[2];
    offer((corner_[0] * weight[0] + corner_[1] * weight[1] + corner_[2] * weight[2]) / sum);
    const bool is_away = dot(corner_[0], normal).high > 0;
    offer_plane(is_away ? normal : PairVector{-normal.x, -normal.y, -normal.z});
  }

  /// Tries the foot on an edge, if it is between the ends, or else the nearer end.
  void try_edge(int i) {
    const PairVector& from = corner_[i];
    const PairVector& to = corner_[(i + 1) % 3];
    const DoublePair of_to = -dot(from, edge_[i]);
    const DoublePair of_from = dot(to, edge_[i]);
    if (!(of_to.high > 0)) return offer(from);
    if (!(of_from.high > 0)) return offer(to);
    offer((from * of_from + to * of_to) / (of_from + of_to));
  }

  void offer(const PairVector& point) {
    const DoublePair square = dot(point, point);
    if (!is_less(square, square_)) return;
    nearest_ = point;
    square_ = square;
  }

  /// Offers the plane across a direction before all corners, by the square of its distance.
  void offer_plane(const PairVector& direction) {
    const PairVector unit = in_units(direction);
    DoublePair least = dot(corner_[0], unit);
    for (int i = 1; i < 3; ++i) {
      const DoublePair along = dot(corner_[i], unit);
      if (is_less(along, least)) least = along;
    }
    const Vec3 normal = unit_or(rounded(unit), {0, 0, 1});
    if (!has_plane_) normal_ = normal;
    if (!(least.high > 0)) return;
    const DoublePair square = (least * least) / dot(unit, unit);
    if (has_plane_ && !is_less(most_, square)) return;
    has_plane_ = true;
    most_ = square;
    normal_ = normal;
  }

  /// Returns how far the root of a square is beyond the radius.
  double beyond(const DoublePair& square) const {
    const double sum = std::sqrt(square.high) + radius_;
    const DoublePair radius{radius_, 0};
    return sum > 0 ? (square - radius * radius).high / sum : 0;
  }

  const Sphere& ball_;
  PairVector corner_[3];
  PairVector edge_[3];  ///< the edge from corner i to the next, each in a unit of its own
  double radius_;
  int exponent_;
  PairVector nearest_{};
  DoublePair square_{std::numeric_limits<double>::infinity(), 0};
  DoublePair most_{0, 0};
  bool has_plane_ = false;
  Vec3 normal_{0, 0, 1};
};

}  // namespace

BallGap ball_gap(const Sphere& ball, const Triangle& triangle) {
  return BallSearch(ball, triangle).run();
}

}  // namespace graze::narrowphase
