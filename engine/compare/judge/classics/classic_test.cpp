#include <graze/engine/compare/judge/classics/classic_test.h>

#include <gmpxx.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

namespace graze::compare {
namespace {

template <typename Scalar>
using Vector = std::array<Scalar, 3>;
template <typename Scalar>
using Corners = std::array<Vector<Scalar>, 3>;

template <typename Scalar>
Vector<Scalar> between(const Vector<Scalar>& p, const Vector<Scalar>& q) {
  return {Scalar(q[0] - p[0]), Scalar(q[1] - p[1]), Scalar(q[2] - p[2])};
}

template <typename Scalar>
Scalar inner(const Vector<Scalar>& p, const Vector<Scalar>& q) {
  const Scalar x = p[0] * q[0];
  const Scalar y = p[1] * q[1];
  const Scalar z = p[2] * q[2];
  const Scalar xy = x + y;
  return Scalar(xy + z);
}

template <typename Scalar>
Vector<Scalar> outer(const Vector<Scalar>& p, const Vector<Scalar>& q) {
  const auto minor = [](const Scalar& a, const Scalar& b, const Scalar& c, const Scalar& d) {
    const Scalar left = a * b;
    const Scalar right = c * d;
    return Scalar(left - right);
  };
  return {minor(p[1], q[2], p[2], q[1]), minor(p[2], q[0], p[0], q[2]),
          minor(p[0], q[1], p[1], q[0])};
}

template <typename Scalar>
int sign_of(const Scalar& value) {
  return (value > 0) - (value < 0);
}

/// Holds a number of a step, and the largest that went into it.
template <typename Scalar>
struct Value {
  Scalar value;
  Scalar largest;
};

template <typename Scalar>
Scalar magnitude(const Scalar& value) {
  return value < 0 ? Scalar(-value) : value;
}

template <typename Scalar>
struct Range {
  Scalar min;
  Scalar max;
};

template <typename Scalar>
Range<Scalar> range_along(const Vector<Scalar>& axis, const Corners<Scalar>& t) {
  Range<Scalar> range{inner(axis, t[0]), inner(axis, t[0])};
  for (const Vector<Scalar>& corner : t) {
    const Scalar at = inner(axis, corner);
    if (at < range.min) range.min = at;
    if (at > range.max) range.max = at;
  }
  return range;
}

/// Returns a gap: if it is positive they are apart along the axis.
template <typename Scalar>
Value<Scalar> gap_of(const Vector<Scalar>& axis, const Corners<Scalar>& a,
                     const Corners<Scalar>& b) {
  const Range<Scalar> of_a = range_along(axis, a);
  const Range<Scalar> of_b = range_along(axis, b);
  const Scalar above = of_b.min - of_a.max;
  const Scalar below = of_a.min - of_b.max;
  Scalar largest = 0;
  for (const Scalar& each : {of_a.min, of_a.max, of_b.min, of_b.max}) {
    const Scalar size = magnitude(each);
    if (size > largest) largest = size;
  }
  return {above > below ? above : below, largest};
}

/// Returns det(q - p, r - p, s - p): on which side of the plane of p, q, r the point s is.
template <typename Scalar>
Value<Scalar> side_of(const Vector<Scalar>& p, const Vector<Scalar>& q, const Vector<Scalar>& r,
                      const Vector<Scalar>& s) {
  const Vector<Scalar> normal = outer(between(p, q), between(p, r));
  const Vector<Scalar> to = between(p, s);
  Scalar largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Scalar term = magnitude(Scalar(normal[i] * to[i]));
    if (term > largest) largest = term;
  }
  return {inner(normal, to), largest};
}

template <typename Scalar>
Vector<Scalar> edge_along(const Corners<Scalar>& t, std::size_t i) {
  return between(t[i], t[(i + 1) % 3]);
}

/// Returns all numbers of a test in one arithmetic, in the order of step_names().
template <typename Scalar>
std::vector<Value<Scalar>> axes_values(const Corners<Scalar>& a, const Corners<Scalar>& b) {
  std::vector<Value<Scalar>> values;
  const Vector<Scalar> normal_a = outer(edge_along(a, 0), edge_along(a, 1));
  const Vector<Scalar> normal_b = outer(edge_along(b, 0), edge_along(b, 1));
  values.push_back(gap_of(normal_a, a, b));
  values.push_back(gap_of(normal_b, a, b));
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      values.push_back(gap_of(outer(edge_along(a, i), edge_along(b, k)), a, b));
  for (std::size_t i = 0; i < 3; ++i)
    values.push_back(gap_of(outer(normal_a, edge_along(a, i)), a, b));
  for (std::size_t k = 0; k < 3; ++k)
    values.push_back(gap_of(outer(normal_b, edge_along(b, k)), a, b));
  return values;
}

template <typename Scalar>
std::vector<Value<Scalar>> determinant_values(const Corners<Scalar>& a, const Corners<Scalar>& b) {
  std::vector<Value<Scalar>> values;
  for (std::size_t i = 0; i < 3; ++i)
    values.push_back(side_of(b[0], b[1], b[2], a[i]));
  for (std::size_t k = 0; k < 3; ++k)
    values.push_back(side_of(a[0], a[1], a[2], b[k]));
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      values.push_back(side_of(a[i], a[(i + 1) % 3], b[k], b[(k + 1) % 3]));
  return values;
}

std::vector<std::string> step_names(ClassicTest test) {
  const auto number = [](std::size_t i) { return std::to_string(i + 1); };
  std::vector<std::string> names;
  if (test == ClassicTest::Axes) {
    names = {"the gap along A's normal", "the gap along B's normal"};
    for (std::size_t i = 0; i < 9; ++i) {
      names.push_back("the gap along edge " + number(i / 3) + " of A x edge " + number(i % 3) +
                      " of B");
    }
    for (std::size_t i = 0; i < 6; ++i) {
      names.push_back(std::string("the gap across edge ") + number(i % 3) + " of " +
                      (i < 3 ? "A" : "B") + " in its plane");
    }
    return names;
  }
  for (std::size_t i = 0; i < 6; ++i) {
    names.push_back(std::string("the side of ") + (i < 3 ? "B" : "A") +
                    "'s plane on which corner " + number(i % 3) + " of " + (i < 3 ? "A" : "B") +
                    " is");
  }
  for (std::size_t i = 0; i < 9; ++i) {
    names.push_back("the side on which edge " + number(i / 3) + " of A passes edge " +
                    number(i % 3) + " of B");
  }
  return names;
}

/// True if an edge of one pierces the other, from the signs of determinant_values().
bool pierces(const std::array<int, 15>& signs) {
  const auto is_same = [](int p, int q, int r) {
    return (p >= 0 && q >= 0 && r >= 0) || (p <= 0 && q <= 0 && r <= 0);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    const bool crosses_b = signs[i] * signs[next] <= 0 && (signs[i] != 0 || signs[next] != 0);
    const std::size_t of_a = 6 + 3 * i;
    if (crosses_b && is_same(signs[of_a], signs[of_a + 1], signs[of_a + 2])) return true;
    const int from = signs[3 + i];
    const int to = signs[3 + next];
    const bool crosses_a = from * to <= 0 && (from != 0 || to != 0);
    if (crosses_a && is_same(signs[6 + i], signs[9 + i], signs[12 + i])) return true;
  }
  return false;
}

bool are_flat(const std::array<int, 15>& signs) {
  return std::all_of(signs.begin(), signs.begin() + 6, [](int sign) { return sign == 0; });
}

template <typename Scalar>
Corners<Scalar> rounded(const Triangle& t) {
  Corners<Scalar> corners;
  const std::array<const Eigen::Vector3d*, 3> from = {&t.a, &t.b, &t.c};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      corners[i][k] = static_cast<Scalar>(from[i]->data()[k]);
  return corners;
}

template <typename Scalar>
Corners<mpq_class> exactly_of(const Corners<Scalar>& t) {
  Corners<mpq_class> corners;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      corners[i][k] = mpq_class(static_cast<double>(t[i][k]));
  return corners;
}

template <typename Scalar>
bool says_of(ClassicTest test, const std::vector<ClassicStep>& steps, const Corners<Scalar>& a,
             const Corners<Scalar>& b) {
  const auto has_gap = [](const auto& all) {
    return std::any_of(all.begin(), all.end(), [](const auto& each) { return each > 0; });
  };
  std::vector<int> signs;
  signs.reserve(steps.size());
  for (const ClassicStep& step : steps)
    signs.push_back(step.computed_sign);
  if (test == ClassicTest::Axes) return !has_gap(signs);
  std::array<int, 15> all{};
  std::copy_n(signs.begin(), all.size(), all.begin());
  if (!are_flat(all)) return pierces(all);
  std::vector<Scalar> gaps;  // for triangles that lie in one plane
  for (const Value<Scalar>& each : axes_values(a, b))
    gaps.push_back(each.value);
  return !has_gap(gaps);
}

template <typename Scalar>
ClassicRun run_in(ClassicTest test, const Triangle& triangle_a, const Triangle& triangle_b) {
  const Corners<Scalar> a = rounded<Scalar>(triangle_a);
  const Corners<Scalar> b = rounded<Scalar>(triangle_b);
  const bool by_axes = test == ClassicTest::Axes;
  const std::vector<Value<Scalar>> computed =
      by_axes ? axes_values(a, b) : determinant_values(a, b);
  const Corners<mpq_class> exact_a = exactly_of(a);
  const Corners<mpq_class> exact_b = exactly_of(b);
  const std::vector<Value<mpq_class>> exact =
      by_axes ? axes_values(exact_a, exact_b) : determinant_values(exact_a, exact_b);
  const std::vector<std::string> names = step_names(test);
  ClassicRun run;
  run.test = test;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto value = static_cast<double>(computed[i].value);
    mpq_class error = 0;  // it is infinite for a number that overflows
    if (std::isfinite(value)) error = abs(mpq_class(value) - exact[i].value);
    const double ulp =
        static_cast<double>(std::numeric_limits<Scalar>::epsilon()) * exact[i].largest.get_d();
    const double off = std::isfinite(value) ? error.get_d() : HUGE_VAL;
    run.steps.push_back({.name = names[i],
                         .computed = value,
                         .exact = exact[i].value.get_d(),
                         .computed_sign = sign_of(computed[i].value),
                         .exact_sign = sign_of(exact[i].value),
                         .ulps = ulp > 0 && std::isfinite(ulp) ? off / ulp : 0});
  }
  run.says = says_of(test, run.steps, a, b);
  return run;
}

}  // namespace

const ClassicStep* ClassicRun::misleading(bool truth) const {
  if (says == truth) return nullptr;
  const ClassicStep* worst = nullptr;
  for (const ClassicStep& step : steps) {
    if (step.computed_sign == step.exact_sign) continue;
    // Among axes one with a gap decides; if the triangles are apart each such axis must have been
    // overlooked.
    if (test == ClassicTest::Axes && (step.computed_sign > 0) == (step.exact_sign > 0)) continue;
    if (worst == nullptr || step.ulps > worst->ulps) worst = &step;
  }
  return worst;
}

ClassicRun run_classic(ClassicTest test, ClassicNumbers numbers, const Triangle& triangle_a,
                       const Triangle& triangle_b) {
  return numbers == ClassicNumbers::Float ? run_in<float>(test, triangle_a, triangle_b)
                                          : run_in<double>(test, triangle_a, triangle_b);
}

}  // namespace graze::compare
