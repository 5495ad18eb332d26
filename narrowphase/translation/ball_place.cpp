// Finds where a ball and a triangle meet: the time is told to so many bits that the centre is known
// to 2^-62 of the least of the radius and the largest coordinate, and all else is exact for that
// time.

#include <graze/narrowphase/derived/double_pair.h>
#include <graze/narrowphase/translation/ball_features.h>
#include <graze/narrowphase/translation/unit_vector.h>

#include <algorithm>
#include <cmath>

namespace graze::narrowphase {
namespace {

// The centre is told to so many bits of the size, with two of them for the length of d.
constexpr int kBitsOfPlace = 62 + 2;

double largest_of(const double* v) {
  return std::max(std::abs(v[0]), std::max(std::abs(v[1]), std::abs(v[2])));
}

/// Returns how many bits behind the point the time needs, from 0 to 2164.
int bits_of_time(const Corners<double>& triangle, const MovingBall& ball) {
  double size = 0;
  for (const double* corner : triangle.point)
    size = std::max(size, largest_of(corner));
  if (ball.radius > 0) size = size > 0 ? std::min(size, ball.radius) : ball.radius;
  const double distance = largest_of(ball.displacement);
  if (size == 0 || distance == 0) return 0;
  return std::max(0, std::ilogb(distance) - std::ilogb(size) + kBitsOfPlace);
}

/// The time numerator / 2^bits.
struct FineTime {
  BigInteger numerator;
  int bits = 0;
};

/// Returns a time that is no more than the smaller root of a gap that is in [time, the next
/// double), and that is less than 2^-bits below it: as all before the root, it has no negative gap,
/// which does not grow.
template <typename Integer>
[[gnu::noinline]] FineTime fine_time(const Polynomial& gap, double time, int bits) {
  Dyadic<Integer> low(time), high(next_double(time));
  const Polynomial slope = derivative(gap);
  while (std::max(low.bits, high.bits) < bits) {
    const Dyadic<Integer> middle = between(low, high);
    const bool is_before =
        sign_at(gap, middle) != Sign::Negative && sign_at(slope, middle) != Sign::Positive;
    (is_before ? low : high) = middle;
  }
  return {BigInteger(low.numerator), low.bits};
}

BigVector sum(const BigVector& v, const BigVector& w) {
  return {v.x + w.x, v.y + w.y, v.z + w.z};
}

BigVector scaled(const BigVector& v, const BigInteger& by) {
  return {v.x * by, v.y * by, v.z * by};
}

/// Returns v - w.
BigVector difference(const BigVector& v, const BigVector& w) {
  return {v.x - w.x, v.y - w.y, v.z - w.z};
}

BigVector shifted(const BigVector& v, int bits) {
  return {v.x.shifted(bits), v.y.shifted(bits), v.z.shifted(bits)};
}

/// Holds what is about a feature when the centre is at c + t d.
///
/// A numerator and 2^bits have at most 2165 bits, so that the longest of these, a product of n^2
/// and 2^bits c + d, has 12670: 198 limbs, and a limb for rounding up.
class FootAt {
 public:
  FootAt(const BallFeatures& features, const Corners<double>& triangle, const MovingBall& ball,
         const BallFeature& feature, const FineTime& time)
      : features_(features),
        triangle_(triangle),
        ball_(ball),
        feature_(feature),
        time_(time),
        arm_(difference(scaled(features.displacement(), time.numerator),
                        shifted(features.corner(feature.place), time.bits))) {}

  Eigen::Vector3d point() const {
    const double* corner = triangle_.point[feature_.place];
    switch (feature_.kind) {
      case BallFeature::Kind::Vertex:
        break;
      case BallFeature::Kind::Edge: {
        const BigVector& edge = features_.edge(feature_.place);
        return rounded(corner, {}, squared(edge), scaled(edge, dot(arm_, edge)));
      }
      case BallFeature::Kind::Face: {
        const BigVector& normal = features_.normal();
        const BigVector moved = scaled(features_.displacement(), time_.numerator);
        const BigInteger square = squared(normal);
        return rounded(ball_.centre, moved, square, scaled(normal, -dot(arm_, normal)));
      }
    }
    return {corner[0], corner[1], corner[2]};
  }

  /// Returns the vector from the foot to the centre, times something positive.
  BigVector offset() const {
    switch (feature_.kind) {
      case BallFeature::Kind::Vertex:
        break;
      case BallFeature::Kind::Edge: {
        const BigVector& edge = features_.edge(feature_.place);
        return cross(edge, cross(arm_, edge));
      }
      case BallFeature::Kind::Face: {
        // The normal is on the side on which the centre began.
        const Sign side = -dot(features_.corner(0), features_.normal()).sign();
        return scaled(features_.normal(), BigInteger::from_double(static_cast<int>(side), 0));
      }
    }
    return arm_;
  }

 private:
  /// Returns base + moved / 2^bits + rest / (divisor 2^bits), in metres.
  Eigen::Vector3d rounded(const double* base, const BigVector& moved, const BigInteger& divisor,
                          const BigVector& rest) const {
    const CommonUnit& unit = features_.unit();
    const BigVector from{unit.of(base[0]), unit.of(base[1]), unit.of(base[2])};
    const BigVector all = sum(scaled(sum(shifted(from, time_.bits), moved), divisor), rest);
    const BigInteger whole = divisor.shifted(time_.bits);
    return {rounded_ratio(all.x, whole, unit.exponent()),
            rounded_ratio(all.y, whole, unit.exponent()),
            rounded_ratio(all.z, whole, unit.exponent())};
  }

  const BallFeatures& features_;
  const Corners<double>& triangle_;
  const MovingBall& ball_;
  const BallFeature& feature_;
  const FineTime& time_;
  BigVector arm_;  ///< from a corner of the feature to the centre, times 2^bits
};

/// Returns the normal for a ball without a radius.
Eigen::Vector3d normal_of_point(const BallFeatures& features, const BallFeature& feature) {
  const BigVector& d = features.displacement();
  if (feature.kind == BallFeature::Kind::Vertex) return unit_against(d, d);
  if (feature.kind == BallFeature::Kind::Face) return unit_against(features.normal(), d);
  const BigVector& edge = features.edge(feature.place);
  return unit_against(cross(edge, cross(edge, d)), d);
}

/// Returns the feature with the point nearest to the centre at t = 0.
BallFeature nearest_at_start(const BallFeatures& features) {
  const auto sign_at_start = [](const Polynomial& f) { return f.coefficient[0].sign(); };
  const BallFeature face{BallFeature::Kind::Face, 0};
  if (features.has(face) && features.is_foot_on(face, sign_at_start)) return face;
  BallFeature nearest = kBallFeatures[0];
  BigInteger least = squared(features.corner(0));  // all squares are times `divisor`, as those of
                                                   // edges are
  BigInteger divisor = BigInteger::from_double(1, 0);
  for (const BallFeature& feature : kBallFeatures) {
    if (feature.kind == BallFeature::Kind::Face || !features.has(feature) ||
        !features.is_foot_on(feature, sign_at_start))
      continue;
    const bool is_edge = feature.kind == BallFeature::Kind::Edge;
    const BigVector &corner = features.corner(feature.place), &edge = features.edge(feature.place);
    const BigInteger square = squared(is_edge ? cross(corner, edge) : corner);
    const BigInteger own_divisor = is_edge ? squared(edge) : BigInteger::from_double(1, 0);
    if ((square * divisor - least * own_divisor).sign() != Sign::Negative) continue;
    nearest = feature;
    least = square;
    divisor = own_divisor;
  }
  return nearest;
}

}  // namespace

BallPlace place_of(const TriangleMeeting& meeting, const MovingBall& ball) {
  const BallFeatures features(meeting.triangle, ball);
  const BallFeature& feature = meeting.meeting.feature;
  const Polynomial gap = features.gap(feature);
  const int bits = bits_of_time(meeting.triangle, ball);
  FineTime time;
  try {
    time = fine_time<BigInteger>(gap, meeting.meeting.time, bits);
  } catch (const CapacityExceeded&) {
    time = fine_time<VastInteger>(gap, meeting.meeting.time, bits);
  }
  const FootAt foot(features, meeting.triangle, ball, feature, time);
  if (ball.radius == 0) return {foot.point(), normal_of_point(features, feature)};
  return {foot.point(), unit_of(foot.offset())};
}

BallPlace place_at_start(const Corners<double>& triangle, const MovingBall& ball) {
  const BallFeatures features(triangle, ball);
  const BallFeature feature = nearest_at_start(features);
  const FineTime start;
  const FootAt foot(features, triangle, ball, feature, start);
  const BigVector offset = foot.offset();
  if (!is_zero(offset)) return {foot.point(), unit_of(offset)};
  const BigVector& d = features.displacement();
  return {foot.point(), unit_against(is_zero(features.normal()) ? d : features.normal(), d)};
}

}  // namespace graze::narrowphase
