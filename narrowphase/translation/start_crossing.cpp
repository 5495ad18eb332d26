// Finds the signs of crossing_stages.cpp directly after t = 0: an orientation changes steadily with
// t, so where it is zero at t = 0 its slope has the sign that it has then.

#include <graze/narrowphase/predicates/plane_sides.h>
#include <graze/narrowphase/translation/axes.h>
#include <graze/narrowphase/translation/translation.h>

#include <utility>

namespace graze::narrowphase {
namespace {

/// A triangle seen from its apex, in an order in which the other's apex is on the positive side.
struct FromApex {
  const double* p;
  const double* q;
  const double* r;

  FromApex(const Corners<double>& t, const Apex& own, const Apex& other)
      : p(t.point[own.index]), q(t.point[(own.index + 1) % 3]), r(t.point[(own.index + 2) % 3]) {
    if (other.side == Sign::Negative) std::swap(q, r);
  }
};

class DirectlyAfter {
 public:
  explicit DirectlyAfter(const TranslatedPair& pair)
      : pair_(pair),
        d_{kZeroPoint, pair.displacement},
        sides_a_(sides(pair.b, pair.a, -d_)),
        sides_b_(sides(pair.a, pair.b, d_)) {}

  bool crosses() const {
    if (sides_a_.are_on_both() && sides_b_.are_on_both()) {
      const Apex apex_a = find_apex(sides_a_.sign), apex_b = find_apex(sides_b_.sign);
      const FromApex s(pair_.a, apex_a, apex_b), t(pair_.b, apex_b, apex_a);
      return of_lines({s.p, s.q}, {t.p, t.q}) == Sign::Negative &&
             of_lines({s.p, s.r}, {t.r, t.p}) == Sign::Negative;
    }
    if (sides_a_.are_on_both() && sides_b_.are_all_zero())
      return pierces(pair_.a, sides_a_, pair_.b, d_);
    if (sides_b_.are_on_both() && sides_a_.are_all_zero())
      return pierces(pair_.b, sides_b_, pair_.a, -d_);
    return false;
  }

 private:
  /// Returns the sides of corners that move by `displacement` against a plane.
  static PlaneSides sides(const Corners<double>& plane, const Corners<double>& other,
                          Step displacement) {
    PlaneSides sides = sides_of_plane(plane, other);
    if (!sides.has(Sign::Zero)) return sides;
    const Sign slope = sign_of_triple({plane.point[0], plane.point[1]},
                                      {plane.point[0], plane.point[2]}, displacement);
    for (Sign& sign : sides.sign) {
      if (sign == Sign::Zero) sign = slope;
    }
    return sides;
  }

  /// Returns orientation_3d() of the ends of two lines, the second of which moves by
  /// `displacement`.
  static Sign of_lines(Step line, Step other, Step displacement) {
    const Sign sign = orientation_3d(line.from, line.to, other.from, other.to);
    return sign != Sign::Zero ? sign : sign_of_triple(line, -other, displacement);
  }
  Sign of_lines(Step line_a, Step line_b) const { return of_lines(line_a, line_b, d_); }

  /// True if a triangle without area goes through the inside of another one, which moves by
  /// `displacement` against it.
  static bool pierces(const Corners<double>& segment, const PlaneSides& sides,
                      const Corners<double>& triangle, Step displacement) {
    const Step line{segment.point[sides.first(Sign::Negative)],
                    segment.point[sides.first(Sign::Positive)]};
    const auto passes = [&](int i) {
      return of_lines(line, {triangle.point[i], triangle.point[(i + 1) % 3]}, displacement);
    };
    const Sign first = passes(0);
    return first != Sign::Zero && passes(1) == first && passes(2) == first;
  }

  const TranslatedPair& pair_;
  Step d_;
  PlaneSides sides_a_;  ///< the sides of A's corners beside B's plane
  PlaneSides sides_b_;
};

}  // namespace

bool crosses_from_start(const TranslatedPair& pair) {
  return DirectlyAfter(pair).crosses();
}

}  // namespace graze::narrowphase
