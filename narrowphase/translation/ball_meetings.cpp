// The integers become as long as follows. If f and g are two polynomials of degree two with
// coefficients of 12605 bits (ball_features.h), roots of f stand 2^-12605 apart at least, a root of
// their discriminant over the highest coefficient, so that 12608 bits behind the point part them.
//
//   f, or g, at ends                 12605 + 2 * 12608 + 8 = 37829 bits
//   f at the vertex of g             12605 + 2 * 12606 + 4 = 37821
//   f reduced by g                   2 * 12605 + 2 = 25212
//   g at the root of that            12605 + 2 * 25212 + 4 = 63033
//
// Of these the longest takes 985 limbs and, since a product asks for the limbs of its factors
// together, each rounded up, a few more: VastInteger has 1000. That is for faces which are met in
// one double of time, and whose coordinates are thousands of binary places apart.

#include <graze/narrowphase/motion/root_sign.h>
#include <graze/narrowphase/translation/ball_features.h>
#include <graze/narrowphase/volumes/spheres/triangle_sphere_stages.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>

#include <utility>

namespace graze::narrowphase {
namespace {

/// Returns the sign of a root less the smaller root of g, which is of degree two and has real
/// roots.
template <typename Integer>
Sign order_of(const RootSigns<Integer>& sign_of, const Polynomial& g) {
  const Sign sign = sign_of(g);
  if (sign == Sign::Negative || sign_of(derivative(g)) == Sign::Positive) return Sign::Positive;
  return -sign;
}

/// Calls `visit(root)` with the smaller root of a gap that is open at 0, if it is in [0, 1]; one
/// outside a stretch may be left out.
template <typename Integer, typename Visit>
void visit_closing(const Polynomial& gap, const BallStretch& stretch, const Visit& visit) {
  if (gap.degree < 2 || gap.coefficient[0].sign() != Sign::Positive) return;
  const Dyadic<Integer> from(stretch.from), until(stretch.until);
  if (sign_at(gap, from) != Sign::Positive) return;
  const Sign last = sign_at(gap, until);
  if (last == Sign::Positive) {
    const Polynomial slope = derivative(gap);
    if (sign_at(slope, from) != Sign::Negative || sign_at(slope, until) != Sign::Positive) return;
  }
  if (last == Sign::Negative) {
    const IntegerPolynomial<Integer> f = in_integers<Integer>(gap);
    Root<Integer> root{f, {from, until, 1, false}};
    narrow(root);
    visit(root);
    return;
  }
  visit_roots<Integer>(gap, 0, [&](Root<Integer>& root) {
    narrow(root);
    visit(root);
    return true;
  });
}

/// Holds what rounded arithmetic tells of which features a ball may meet up to a time.
class MetFeatures {
 public:
  MetFeatures(const Corners<double>& triangle, const MovingBall& ball, const BallStretch& stretch)
      : triangle_(triangle),
        ball_{{ball.centre[0], ball.centre[1], ball.centre[2]}, ball.radius},
        displacement_(ball.displacement[0], ball.displacement[1], ball.displacement[2]),
        stretch_(stretch) {}

  const BallStretch& stretch() const { return stretch_; }

  /// True only for a corner, or an edge with its ends, that the ball does not meet.
  bool is_passed(const BallFeature& feature) const {
    if (feature.kind == BallFeature::Kind::Face) return false;
    const int last = feature.kind == BallFeature::Kind::Edge ? 1 : 0;
    const Eigen::Vector3d from = corner(feature.place), to = corner(feature.place + last);
    return is_surely_passed({from, to, to}, ball_, displacement_, stretch_.until);
  }

 private:
  Eigen::Vector3d corner(int i) const {
    const double* p = triangle_.point[i % 3];
    return {p[0], p[1], p[2]};
  }

  const Corners<double>& triangle_;
  Sphere ball_;
  Eigen::Vector3d displacement_;
  BallStretch stretch_;
};

template <typename Integer>
class FirstMeeting {
 public:
  FirstMeeting(const Corners<double>& triangle, const MovingBall& ball)
      : features_(triangle, ball) {}

  std::optional<BallMeeting> find(const MetFeatures& met) {
    for (const BallFeature& feature : kBallFeatures) {
      if (met.is_passed(feature) || !features_.has(feature)) continue;
      const Polynomial gap = features_.gap(feature);
      visit_closing<Integer>(gap, met.stretch(),
                             [&](const Root<Integer>& root) { ask(feature, gap, root); });
    }
    return first_;
  }

 private:
  void ask(const BallFeature& feature, const Polynomial& gap, const Root<Integer>& root) {
    const double time = root.place.low.floor;
    if (first_ && first_->time < time) return;
    const RootSigns<Integer> sign_of(root);
    if (!features_.is_foot_on(feature, sign_of)) return;
    if (first_ && first_->time == time && order_of(sign_of, gap_) != Sign::Negative) return;
    first_ = BallMeeting{feature, time};
    gap_ = gap;
  }

  BallFeatures features_;
  std::optional<BallMeeting> first_;
  Polynomial gap_;  ///< the gap of the first
};

// This is not inlined: the frame of the one is not to hold the integers of the other.

template <typename Integer>
[[gnu::noinline]] std::optional<BallMeeting> first_meeting_in(const Corners<double>& triangle,
                                                              const MovingBall& ball,
                                                              const MetFeatures& met) {
  return FirstMeeting<Integer>(triangle, ball).find(met);
}

template <typename Integer>
[[gnu::noinline]] Sign compare_in(const Polynomial& s, const Polynomial& t) {
  Sign order = Sign::Zero;
  visit_closing<Integer>(
      s, {}, [&](const Root<Integer>& root) { order = order_of(RootSigns<Integer>(root), t); });
  return order;
}

bool are_one_point(const double* p, const double* q) {
  return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

/// True if both meet one feature. Neighbours are mostly met at what they share: a corner, or an
/// edge.
bool are_one_feature(const TriangleMeeting& s, const TriangleMeeting& t) {
  const BallFeature &of_s = s.meeting.feature, &of_t = t.meeting.feature;
  if (of_s.kind != of_t.kind || of_s.kind == BallFeature::Kind::Face) return false;
  const auto point = [](const TriangleMeeting& of, int next) {
    return of.triangle.point[(of.meeting.feature.place + next) % 3];
  };
  const bool are_from_equal = are_one_point(point(s, 0), point(t, 0));
  if (of_s.kind == BallFeature::Kind::Vertex) return are_from_equal;
  return (are_from_equal && are_one_point(point(s, 1), point(t, 1))) ||
         (are_one_point(point(s, 0), point(t, 1)) && are_one_point(point(s, 1), point(t, 0)));
}

}  // namespace

std::optional<BallMeeting> first_meeting(const Corners<double>& triangle, const MovingBall& ball,
                                         const BallStretch& stretch) {
  const MetFeatures met(triangle, ball, stretch);
  try {
    return first_meeting_in<BigInteger>(triangle, ball, met);
  } catch (const CapacityExceeded&) {
    return first_meeting_in<VastInteger>(triangle, ball, met);
  }
}

Sign compare(const TriangleMeeting& s, const TriangleMeeting& t, const MovingBall& ball) {
  if (s.meeting.time != t.meeting.time)
    return s.meeting.time < t.meeting.time ? Sign::Negative : Sign::Positive;
  if (are_one_feature(s, t)) return Sign::Zero;
  const Polynomial gap_s = BallFeatures(s.triangle, ball).gap(s.meeting.feature);
  const Polynomial gap_t = BallFeatures(t.triangle, ball).gap(t.meeting.feature);
  try {
    return compare_in<BigInteger>(gap_s, gap_t);
  } catch (const CapacityExceeded&) {
    return compare_in<VastInteger>(gap_s, gap_t);
  }
}

// The squared distance is convex: it comes below r^2 directly after t = 0 if its slope is negative
// where it is r^2, and never if not.
bool goes_in_from_start(const Corners<double>& triangle, const MovingBall& ball) {
  const BallFeatures features(triangle, ball);
  bool goes_in = false;
  for (const BallFeature& feature : kBallFeatures) {
    const auto sign_at_start = [](const Polynomial& f) { return f.coefficient[0].sign(); };
    if (!features.has(feature) || !features.is_foot_on(feature, sign_at_start)) continue;
    const Polynomial gap = features.gap(feature);
    const Sign sign = sign_at_start(gap);
    if (sign == Sign::Negative) return true;
    if (sign == Sign::Zero && gap.coefficient[1].sign() == Sign::Negative) goes_in = true;
  }
  return goes_in;
}

}  // namespace graze::narrowphase
