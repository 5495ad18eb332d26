#include <graze/narrowphase/derived/double_pair.h>
#include <graze/narrowphase/motion/times.h>
#include <graze/narrowphase/predicates/exact_vector.h>
#include <graze/narrowphase/translation/axes.h>
#include <graze/narrowphase/translation/meeting_time.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::narrowphase {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Holds numerator and divisor as integers, the divisor positive. A difference of coordinates has
/// at most 2099 bits, a product of three as a sum of six 6300: two of these multiplied fit
/// (BigInteger).
struct ExactTime {
  BigInteger numerator;
  BigInteger divisor;

  explicit ExactTime(const TimeQuotient& time) {
    CommonUnit unit({});
    for (const Step& step : {time.p, time.q, time.w, time.d}) {
      unit.include(step.from, 3);
      unit.include(step.to, 3);
    }
    const auto exactly = [&](Step step) { return BigVector::difference(step.to, step.from, unit); };
    const BigVector across = cross(exactly(time.p), exactly(time.q));
    numerator = dot(across, exactly(time.w));
    divisor = dot(across, exactly(time.d));
    if (divisor.sign() != Sign::Negative) return;
    numerator = -numerator;
    divisor = -divisor;
  }
};

bool are_equal(const double* p, const double* q) {
  return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

bool are_equal(Step s, Step t) {
  return are_equal(s.from, t.from) && are_equal(s.to, t.to);
}

bool are_equal_or_opposite(Step s, Step t) {
  return are_equal(s, t) || are_equal(s, -t);
}

/// True if both are surely one time. What meets of neighbours is often what they share: a corner,
/// or an edge, whose ends w then may come from in either order.
bool are_surely_equal(const TimeQuotient& s, const TimeQuotient& t) {
  if (!are_equal_or_opposite(s.p, t.p) || !are_equal_or_opposite(s.q, t.q)) return false;
  if (are_equal(s.w, t.w)) return true;
  if (!s.is_of_edges || !t.is_of_edges) return false;
  const auto is_end = [](const double* point, Step edge) {
    return are_equal(point, edge.from) || are_equal(point, edge.to);
  };
  return is_end(s.w.to, s.p) && is_end(t.w.to, s.p) && is_end(s.w.from, s.q) &&
         is_end(t.w.from, s.q);
}

}  // namespace

TimeQuotient::TimeQuotient(const TranslatedPair& pair, const Meeting& meeting)
    : p{},
      q{},
      w{},
      d{kZeroPoint, pair.displacement},
      is_of_edges(meeting.kind == Meeting::Kind::EdgeEdge) {
  const Corners<double>&a = pair.a, &b = pair.b;
  const int next_a = (meeting.a + 1) % 3, next_b = (meeting.b + 1) % 3;
  w = {b.point[meeting.b], a.point[meeting.a]};
  switch (meeting.kind) {
    case Meeting::Kind::VertexFace:
      p = {b.point[0], b.point[1]};
      q = {b.point[0], b.point[2]};
      break;
    case Meeting::Kind::FaceVertex:
      p = {a.point[0], a.point[1]};
      q = {a.point[0], a.point[2]};
      break;
    case Meeting::Kind::EdgeEdge:
      p = {a.point[meeting.a], a.point[next_a]};
      q = {b.point[meeting.b], b.point[next_b]};
      break;
    case Meeting::Kind::VertexOnEdge:
      p = {b.point[meeting.b], b.point[next_b]};
      q = axis_step(meeting.axis);
      break;
    case Meeting::Kind::EdgeWithVertex:
      p = {a.point[meeting.a], a.point[next_a]};
      q = axis_step(meeting.axis);
      break;
    case Meeting::Kind::VertexVertex:
      p = axis_step((meeting.axis + 1) % 3);
      q = axis_step((meeting.axis + 2) % 3);
      break;
  }
}

// Each operation is followed by one step to the next double, which is more than it rounds off.
TimeBounds bounds_of(const TimeQuotient& time) {
  const auto [numerator, divisor] = rounded_triples(time.p, time.q, time.w, time.d);
  const double size = std::abs(divisor.value);
  if (!(size - divisor.bound > 0) || numerator.bound == kInfinity) return {0, kInfinity};
  const double least = previous_double(size - divisor.bound);
  const double most = next_double(size + divisor.bound);
  const double value = divisor.value < 0 ? -numerator.value : numerator.value;
  TimeBounds bounds{0, kInfinity};
  if (value - numerator.bound > 0) {
    const double low = previous_double(value - numerator.bound) / most;
    if (low > 0) bounds.low = previous_double(low);
  }
  const double high = next_double(std::max(0.0, value + numerator.bound)) / least;
  if (high < kInfinity) bounds.high = next_double(high);
  return bounds;
}

Sign sign_of(const TimeQuotient& time) {
  const Sign divisor = sign_of_triple(time.p, time.q, time.d);
  const Sign numerator = sign_of_triple(time.p, time.q, time.w);
  return divisor == Sign::Negative ? -numerator : numerator;
}

Sign compare(const MeetingTime& s, const MeetingTime& t) {
  if (s.bounds.high < t.bounds.low) return Sign::Negative;
  if (s.bounds.low > t.bounds.high) return Sign::Positive;
  if (are_surely_equal(s.quotient, t.quotient)) return Sign::Zero;
  const ExactTime exact_s(s.quotient), exact_t(t.quotient);
  return (exact_s.numerator * exact_t.divisor - exact_t.numerator * exact_s.divisor).sign();
}

bool is_above_one(const MeetingTime& time) {
  if (time.bounds.high <= 1) return false;
  if (time.bounds.low > 1) return true;
  const ExactTime exact(time.quotient);
  return (exact.numerator - exact.divisor).sign() == Sign::Positive;
}

double rounded_down(const TimeQuotient& quotient) {
  const ExactTime exact(quotient);
  const auto is_above_time = [&](double value) {
    if (value == 0) return false;
    const int unit = exponent_of_lowest_bit(value);
    return (BigInteger::from_double(value, unit) * exact.divisor - exact.numerator.shifted(-unit))
               .sign() == Sign::Positive;
  };
  double time = std::min(rounded_ratio(exact.numerator, exact.divisor, 0), 1.0);
  while (is_above_time(time))
    time = previous_double(time);
  while (time < 1 && !is_above_time(next_double(time)))
    time = next_double(time);
  return time;
}

}  // namespace graze::narrowphase
