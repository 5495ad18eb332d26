#include "tests/narrowphase/motion/rational_contact.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <initializer_list>
#include <string>

#include "tests/narrowphase/motion/rational_polynomial.h"

namespace graze::oracle {
namespace {

using Vector = std::array<RationalPolynomial, 3>;

Vector path_of(const PointPath& path) {
  Vector result;
  for (int k = 0; k < 3; ++k) {
    const mpq_class start(path.start[k]), end(path.end[k]);
    result[k] = RationalPolynomial{start, 0} + RationalPolynomial{0, end - start};
  }
  return result;
}

Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

RationalPolynomial dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

using SignOf = std::function<int(const RationalPolynomial&)>;

/// A point in the hull of two others, or a triangle's: by lengths of cross products and products
/// along edges, in space.
struct Segment {
  RationalPolynomial beside;  ///< the square of a cross product: zero on the line
  RationalPolynomial along;   ///< not positive between the ends

  Segment(const Vector& p, const Vector& a, const Vector& b) {
    const Vector away = cross(minus(p, a), minus(b, a));
    beside = dot(away, away);
    along = dot(minus(p, a), minus(p, b));
  }
  bool holds(const SignOf& sign_of) const { return sign_of(beside) == 0 && sign_of(along) <= 0; }
};

struct Question {
  void settle() {
    volume = in_integers(volume);
    area = in_integers(area);
    for (RationalPolynomial& f : sides)
      f = in_integers(f);
    for (Segment& s : segments) {
      s.beside = in_integers(s.beside);
      s.along = in_integers(s.along);
    }
  }

  RationalPolynomial volume;
  RationalPolynomial area;                ///< the square of the normal
  std::vector<RationalPolynomial> sides;  ///< where there is area, none is negative in contact
  std::vector<Segment> segments;          ///< where there is none, one of these holds

  bool holds(const SignOf& sign_of) const {
    if (sign_of(volume) != 0) return false;
    if (sign_of(area) != 0)
      return std::all_of(sides.begin(), sides.end(),
                         [&](const auto& f) { return sign_of(f) >= 0; });
    return std::any_of(segments.begin(), segments.end(),
                       [&](const Segment& s) { return s.holds(sign_of); });
  }

  std::vector<RationalPolynomial> all() const {
    if (!volume.empty()) return {volume};
    std::vector<RationalPolynomial> result = sides;
    result.push_back(area);
    for (const Segment& s : segments) {
      result.push_back(s.beside);
      result.push_back(s.along);
    }
    return result;
  }
};

Question question(const PointPath& point, const TrianglePath& triangle) {
  const Vector p = path_of(point);
  const Vector v[3] = {path_of(triangle.a), path_of(triangle.b), path_of(triangle.c)};
  const Vector n = cross(minus(v[1], v[0]), minus(v[2], v[0]));
  Question result;
  result.volume = dot(n, minus(p, v[0]));
  result.area = dot(n, n);
  for (int i = 0; i < 3; ++i) {
    const Vector &from = v[i], &to = v[(i + 1) % 3];
    result.sides.push_back(dot(n, cross(minus(to, from), minus(p, from))));
    result.segments.emplace_back(p, from, to);
  }
  result.settle();
  return result;
}

Question question(const EdgePath& edge_a, const EdgePath& edge_b) {
  const Vector p = path_of(edge_a.a), q = path_of(edge_a.b);
  const Vector r = path_of(edge_b.a), s = path_of(edge_b.b);
  const Vector n = cross(minus(q, p), minus(s, r));
  Question result;
  result.volume = dot(n, minus(r, p));
  result.area = dot(n, n);
  // p + x (q - p) = r + y (s - r), both sides times the square of n.
  const RationalPolynomial x = dot(n, cross(minus(r, p), minus(s, r))),
                           y = dot(n, cross(minus(r, p), minus(q, p)));
  result.sides = {x, result.area - x, y, result.area - y};
  result.segments = {{p, r, s}, {q, r, s}, {r, p, q}, {s, p, q}};
  result.settle();
  return result;
}

std::optional<FirstContact> answer(const Question& question, StartContact start) {
  std::vector<RationalPolynomial> polynomials;
  for (const RationalPolynomial& f : question.all()) {
    if (!f.empty()) polynomials.push_back(square_free(f));
  }
  std::vector<RationalRoot> roots = all_roots(polynomials);
  const auto holds_at = [&](const mpq_class& t) {
    return question.holds([&](const RationalPolynomial& g) { return sign_of_value(g, t); });
  };
  // What lies between 0 and the first root, the first root, and so on.
  bool is_leaving = holds_at(0);
  if (is_leaving && start == StartContact::Counts) return FirstContact{0, true};
  mpq_class reached = 0;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    RationalRoot& root = roots[i];
    if (i > 0) compare(roots[i - 1], root);  // so that their stretches are apart
    if (i > 0) reached = roots[i - 1].high;
    if (root.low > 0) is_leaving = is_leaving && holds_at((reached + root.low) / 2);
    const bool holds =
        question.holds([&](const RationalPolynomial& g) { return sign_at(g, root); });
    if (holds && !is_leaving) return FirstContact{rounded_down(root), false};
    is_leaving = is_leaving && holds;
  }
  return std::nullopt;
}

std::string text(const Eigen::Vector3d& p) {
  char line[120];
  std::snprintf(line, sizeof line, "{%a, %a, %a}", p.x(), p.y(), p.z());
  return line;
}

/// Put together by append: of sums, g++ 12 says falsely at -O3 that parts of them overlap.
std::string in_braces(std::initializer_list<std::string> parts) {
  std::string result;
  for (const std::string& part : parts)
    result.append(result.empty() ? "{" : ", ").append(part);
  return result.append("}");
}

}  // namespace

std::optional<FirstContact> rational_first_contact(const PointPath& point,
                                                   const TrianglePath& triangle,
                                                   StartContact start) {
  return answer(question(point, triangle), start);
}

std::optional<FirstContact> rational_first_contact(const EdgePath& a, const EdgePath& b,
                                                   StartContact start) {
  return answer(question(a, b), start);
}

std::string text_of(const std::optional<FirstContact>& contact) {
  if (!contact) return "none";
  char line[80];
  std::snprintf(line, sizeof line, "%a (%.17g)%s", contact->time, contact->time,
                contact->is_at_start ? " at the start" : "");
  return line;
}

std::string text_of(const PointPath& path) {
  return in_braces({text(path.start), text(path.end)});
}

std::string text_of(const EdgePath& path) {
  return in_braces({text_of(path.a), text_of(path.b)});
}

std::string text_of(const TrianglePath& path) {
  return in_braces({text_of(path.a), text_of(path.b), text_of(path.c)});
}

}  // namespace graze::oracle
