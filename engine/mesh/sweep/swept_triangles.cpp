// P, the differences of two triangles' points, is a convex polytope. The line along the direction
// meets it, and leaves it, where the normals of its facets say: of a face of either triangle or
// across an edge of each. Where P is flat and holds the direction, its edges do, by their normals
// in the plane of edge and direction; across the direction, P is bounded by its outline.
//
// The margin, u = 2^-53, in units in which all placed coordinates are below 1 and those of B, while
// it can still meet A, below 4: law 1 places a vertex of B, moved, by t' = t + s d, off by u |s d|
// and u |t'|, and r + t', off by u of itself, where it had rounded r + t before: 4 (4 u) at most.
// Each difference of coordinates is off by u of 2; a product with n by 4 u of 2: together 26 u of
// the size of n, and what underflows is less than another.

#include <graze/bvh/value/dot.h>
#include <graze/engine/mesh/sweep/sweep.h>
#include <graze/engine/mesh/sweep/swept_triangles.h>

#include <algorithm>
#include <cmath>

namespace graze::contacts {
namespace {

constexpr double kMargin = 32 * kUnitRoundoff;

using bvh::dot;

struct Vector {
  double at[3];
};

Vector cross(const double* a, const double* b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

/// The differences of the corners, and the bounds of s that are known.
class Differences {
 public:
  Differences(const SweptTriangle& a, const SweptTriangle& b, const double (&direction)[3],
              double enough)
      : direction_(direction), enough_(enough), bounds_(kMargin) {
    for (int i = 0; i < 9; ++i) {
      for (int k = 0; k < 3; ++k)
        difference_[i][k] = a.corner[i / 3][k] - b.corner[i % 3][k];
    }
  }

  /// Asks one more vector. Returns true if all is known that is wanted.
  bool ask(const Vector& n) {
    double lowest = dot(n.at, difference_[0]);
    double highest = lowest;
    for (int i = 1; i < 9; ++i) {
      const double value = dot(n.at, difference_[i]);
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
    const double size = std::abs(n.at[0]) + std::abs(n.at[1]) + std::abs(n.at[2]);
    bounds_.note(dot(n.at, direction_), size, lowest, highest);
    return bounds_.is_empty() || bounds_.upper() <= enough_;
  }

  /// Returns a vector across the direction, from one triangle to the other.
  Vector sideways() const {
    const double* w = difference_[0];
    const double along = dot(w, direction_);
    return {
        {w[0] - along * direction_[0], w[1] - along * direction_[1], w[2] - along * direction_[2]}};
  }

  double last() const { return bounds_.is_empty() ? -1 : bounds_.upper(); }

 private:
  const double (&direction_)[3];
  double enough_;
  SweepBounds bounds_;
  double difference_[9][3];
};

}  // namespace

SweptTriangle::SweptTriangle(const Triangle& placed, double per_metre) {
  const double* points[3] = {placed.a.data(), placed.b.data(), placed.c.data()};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      corner[i][k] = points[i][k] * per_metre;
  }
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      edge[i][k] = corner[(i + 1) % 3][k] - corner[i][k];
  }
}

double last_contact(const SweptTriangle& a, const SweptTriangle& b, const double (&direction)[3],
                    double enough) {
  Differences differences(a, b, direction, enough);
  const auto is_known = [&] {
    if (differences.ask({{direction[0], direction[1], direction[2]}})) return true;
    if (differences.ask(differences.sideways())) return true;
    for (const SweptTriangle* t : {&a, &b}) {
      for (const double(&edge)[3] : t->edge) {
        if (differences.ask(cross(edge, direction))) return true;
      }
    }
    for (const SweptTriangle* t : {&a, &b}) {
      if (differences.ask(cross(t->edge[0], t->edge[1]))) return true;
    }
    for (const double(&edge_a)[3] : a.edge) {
      for (const double(&edge_b)[3] : b.edge) {
        if (differences.ask(cross(edge_a, edge_b))) return true;
      }
    }
    for (const SweptTriangle* t : {&a, &b}) {
      for (const double(&edge)[3] : t->edge) {
        if (differences.ask(cross(cross(edge, direction).at, edge))) return true;
      }
    }
    return false;
  };
  is_known();
  return differences.last();
}

}  // namespace graze::contacts
