// This is a guess and two proofs. Rounded arithmetic guesses the nearest point of the triangle and
// a direction that separates; then one bound proves that *some* point of the triangle, the one with
// the guessed weights, is within the radius, or that *this* direction separates, however it was
// found. So the guess may be wrong: that costs a sure answer, never a right one. Notation as in
// predicates.cpp: u is the unit roundoff, n the smallest double.

#include <graze/narrowphase/volumes/spheres/triangle_sphere_stages.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>
#include <algorithm>
#include <cmath>

namespace graze::narrowphase {
namespace {

constexpr double kUnitRoundoff = 0x1p-53;

// V_i are the corners seen from the centre, each component a rounded difference of inputs, at most
// M in size; r is the radius.
//
// Apart along a direction q, doubles taken as they are, with S = |q_x| + |q_y| + |q_z|: a product
// V_i . q carries four roundings: it is off by at most 4.001 u M S and 1.5 n. For q^2 >= 2^-900 the
// root of q^2 is off by 2.6 u of itself, and R = r |q|, the scaled radius, by 3.61 u of itself and
// n / 2. The triangle is apart if all V_i . q exceed R by more than 4.001 u M S + 3.61 u R + 2 n.
// Computing and adding up this slack rounds by 6.01 u of itself, and adding it to R by
// 1.01 u (R + slack): 4.63 u R and 4.01 u M S in all.
//
// Touching at the point sum w_i V_i / W, with W = sum w_i and any w_i >= 0 taken as they are: each
// component of the sum is off by at most 4.001 u M W and 1.5 n, the vector by sqrt(3) times that:
// 6.94 u M W + 2.6 n. Its computed length is off by 2.6 u of itself, and by 2^-536 where squares
// underflow; R = r W, the scaled radius, by 3.01 u of itself and n / 2. There is a hit if length
// and slack add up to less than R, where the length is below R, too: 6.94 u M W + 5.61 u R +
// 2^-536, and 1.01 u R for adding: 6.95 u M W + 6.63 u R in all.
constexpr double kBound = 8 * kUnitRoundoff;
constexpr double kApartUnderflow = 0x1p-1000;
constexpr double kTouchingUnderflow = 0x1p-500;
constexpr double kSmallestSquare = 0x1p-900;

// With V_i up to 2^150 in size nothing overflows unseen: directions (degree three at most) times
// corners stay below 2^610, and whatever is infinite or NaN makes both sides of a comparison, or
// the greater one, so; none is then true. In size down to about 2^-140 underflow spoils no proof.
constexpr double kLargest = 0x1p+150;

using Vector = double[3];

double dot(const Vector& a, const Vector& b) {
  return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}

void cross(const Vector& a, const Vector& b, Vector& product) {
  product[0] = a[1] * b[2] - a[2] * b[1];
  product[1] = a[2] * b[0] - a[0] * b[2];
  product[2] = a[0] * b[1] - a[1] * b[0];
}

struct Centred {
  Vector corner[3];  ///< V_i of the derivation above
  double largest;    ///< M of the derivation above
  double radius;
  bool is_in_range;
};

Centred centred(const Triangle& triangle, const Sphere& sphere) {
  const double* p[3] = {triangle.a.data(), triangle.b.data(), triangle.c.data()};
  Centred t;
  t.radius = sphere.radius;
  t.largest = 0;
  t.is_in_range = sphere.radius >= 0 && sphere.radius <= kLargest;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      t.corner[i][k] = p[i][k] - sphere.centre.data()[k];
      // Written so that NaN fails.
      t.is_in_range &= std::abs(t.corner[i][k]) <= kLargest;
      t.largest = std::max(t.largest, std::abs(t.corner[i][k]));
    }
  }
  return t;
}

/// True if an axis separates the two. It needs no bound, because rounding is monotone and the
/// radius is a double.
bool is_apart_along_axes(const Centred& t) {
  bool is_apart = false;
  for (int k = 0; k < 3; ++k) {
    const double a = t.corner[0][k];
    const double b = t.corner[1][k];
    const double c = t.corner[2][k];
    is_apart |= (a > t.radius) & (b > t.radius) & (c > t.radius);
    is_apart |= (a < -t.radius) & (b < -t.radius) & (c < -t.radius);
  }
  return is_apart;
}

using Edges = Vector[3];  // from corner i to the next

void find_edges(const Triangle& triangle, Edges& edge) {
  const double* p[3] = {triangle.a.data(), triangle.b.data(), triangle.c.data()};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      edge[i][k] = p[(i + 1) % 3][k] - p[i][k];
  }
}

struct Guess {
  double weight[3] = {0, 0, 0};  ///< weights of the corners, for the nearest point
  Vector direction;              ///< from the centre towards the triangle
};

void guess_vertex(const Centred& t, Guess& guess) {
  int nearest = 0;
  for (int i = 1; i < 3; ++i) {
    if (dot(t.corner[i], t.corner[i]) < dot(t.corner[nearest], t.corner[nearest])) nearest = i;
  }
  guess.weight[nearest] = 1;
  std::copy_n(t.corner[nearest], 3, guess.direction);
}

/// Finds the edge beyond whose line the centre lies, with its foot between the ends: there is at
/// most one such. `weight` are the barycentric coordinates of the foot on the plane, scaled.
bool guess_edge(const Centred& t, const Edges& edge, const double* weight, Guess& guess) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (weight[(i + 2) % 3] > 0) continue;
    const double to_end = dot(t.corner[j], edge[i]);
    const double from_start = -dot(t.corner[i], edge[i]);
    if (!(to_end > 0 && from_start > 0)) continue;
    guess.weight[i] = to_end;
    guess.weight[j] = from_start;
    for (int k = 0; k < 3; ++k)
      guess.direction[k] = to_end * t.corner[i][k] + from_start * t.corner[j][k];
    return true;
  }
  return false;
}

Guess guess_nearest(const Centred& t, const Edges& edge) {
  Guess guess;
  Vector normal;
  cross(edge[0], edge[1], normal);
  double weight[3];
  for (int i = 0; i < 3; ++i) {
    Vector area;
    cross(t.corner[(i + 1) % 3], t.corner[(i + 2) % 3], area);
    weight[i] = dot(area, normal);
  }
  if (weight[0] > 0 && weight[1] > 0 && weight[2] > 0) {
    const double side = dot(t.corner[0], normal) < 0 ? -1 : 1;
    const double scale = 1 / (weight[0] + weight[1] + weight[2]);  // degree four is far out
    for (int k = 0; k < 3; ++k) {
      guess.weight[k] = scale * weight[k];
      guess.direction[k] = side * normal[k];
    }
  } else if (!guess_edge(t, edge, weight, guess)) {
    guess_vertex(t, guess);
  }
  return guess;
}

bool is_touching_at(const double* weight, const Centred& t) {
  const double total = (weight[0] + weight[1]) + weight[2];
  Vector sum;
  for (int k = 0; k < 3; ++k) {
    sum[k] = (weight[0] * t.corner[0][k] + weight[1] * t.corner[1][k]) + weight[2] * t.corner[2][k];
  }
  const double length = std::sqrt(dot(sum, sum));
  const double scaled_radius = t.radius * total;
  return length + (kBound * (t.largest * total + scaled_radius) + kTouchingUnderflow) <
         scaled_radius;
}

bool is_apart_along(const Vector& q, const Centred& t) {
  const double square = dot(q, q);
  if (!(square >= kSmallestSquare)) return false;
  const double size = (std::abs(q[0]) + std::abs(q[1])) + std::abs(q[2]);
  const double a = dot(t.corner[0], q);
  const double b = dot(t.corner[1], q);
  const double c = dot(t.corner[2], q);
  const double scaled_radius = t.radius * std::sqrt(square);
  const double least =
      scaled_radius + (kBound * (t.largest * size + scaled_radius) + kApartUnderflow);
  return a > least && b > least && c > least;
}

// Each coordinate of the centre at `until`, c + until d, is off by u of the product and u of the
// sum, that is by less than 2.01 u (|c| + |until d|), and by n / 2 where the product underflows.
// The centre is off by no more than the sum of these, at most 6.03 u (|c| + |until d|) with the
// larger of both in any coordinate. A ball at the rounded centre that is so much larger holds the
// one that is there, and one that is so much smaller is held by it.
struct MovedBall {
  Sphere at;    ///< the ball with the radius that it has
  double room;  ///< the difference by which radii are made larger or smaller
};

MovedBall moved(const Sphere& sphere, const Eigen::Vector3d& d, double until) {
  constexpr double kCentreBound = 8 * kUnitRoundoff;
  constexpr double kCentreUnderflow = 0x1p-1000;
  MovedBall later{sphere, 0};
  double largest = 0, longest = 0;
  for (int k = 0; k < 3; ++k) {
    const double shift = until * d.data()[k];
    later.at.centre.data()[k] = sphere.centre.data()[k] + shift;
    largest = std::max(largest, std::abs(sphere.centre.data()[k]));
    longest = std::max(longest, std::abs(shift));
  }
  later.room = kCentreBound * (largest + longest) + kCentreUnderflow;
  return later;
}

/// Returns the triangle roughly as seen from where the path, up to a time, is nearest to the point
/// of these weights.
Centred passing_by(const double* weight, const Centred& at_start, const Eigen::Vector3d& d,
                   double until) {
  const double total = (weight[0] + weight[1]) + weight[2];
  double along = 0, square = 0;
  for (int k = 0; k < 3; ++k) {
    const double shift = d.data()[k];
    for (int i = 0; i < 3; ++i)
      along += weight[i] * at_start.corner[i][k] * shift;
    square += shift * shift;
  }
  const double time = std::clamp(along / (total * square), 0.0, until);
  Centred passing = at_start;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      passing.corner[i][k] -= time * d.data()[k];
  }
  return passing;
}

// The factors differ from 1 by more than the sum rounds off.
constexpr double kLargerBall = 1 + 4 * kUnitRoundoff;
constexpr double kSmallerBall = 1 - 4 * kUnitRoundoff;

}  // namespace

Verdict triage(const Triangle& triangle, const Sphere& sphere) {
  const Centred t = centred(triangle, sphere);
  if (!t.is_in_range) return Verdict::Unsure;
  if (is_apart_along_axes(t)) return Verdict::No;
  Edges edge;
  find_edges(triangle, edge);
  const Guess guess = guess_nearest(t, edge);
  if (is_touching_at(guess.weight, t)) return Verdict::Yes;
  if (is_apart_along(guess.direction, t)) return Verdict::No;
  return Verdict::Unsure;
}

// A plane that separates something from two balls separates it from their hull. Where the nearest
// points at neither end give such a plane, the ball passes the triangle in between: going from a
// point of the triangle to the nearest of the path, and back, leads to where.
bool is_surely_passed(const Triangle& triangle, const Sphere& sphere, const Eigen::Vector3d& d,
                      double until) {
  constexpr int kSteps = 4;
  MovedBall later = moved(sphere, d, until);
  later.at.radius = (sphere.radius + later.room) * kLargerBall;
  const Centred at_start = centred(triangle, sphere), at_end = centred(triangle, later.at);
  if (!at_start.is_in_range || !at_end.is_in_range) return false;
  Edges edge;
  find_edges(triangle, edge);
  const auto separates = [&](const Guess& guess) {
    return is_apart_along(guess.direction, at_start) && is_apart_along(guess.direction, at_end);
  };
  if (separates(guess_nearest(at_end, edge))) return true;
  Guess guess = guess_nearest(at_start, edge);
  for (int step = 0; step < kSteps; ++step) {
    if (separates(guess)) return true;
    const Centred passing = passing_by(guess.weight, at_start, d, until);
    if (is_touching_at(guess.weight, passing)) return false;
    guess = guess_nearest(passing, edge);
  }
  return false;
}

bool is_surely_met(const Triangle& triangle, const Sphere& sphere, const Eigen::Vector3d& d,
                   double at) {
  MovedBall later = moved(sphere, d, at);
  later.at.radius = (sphere.radius - later.room) * kSmallerBall;
  const Centred centred_there = centred(triangle, later.at);
  if (!centred_there.is_in_range) return false;
  Edges edge;
  find_edges(triangle, edge);
  return is_touching_at(guess_nearest(centred_there, edge).weight, centred_there);
}

}  // namespace graze::narrowphase
