#pragma once

// Finds signs of products of differences of points, which decide which features of two triangles
// are nearest. They are exact for all finite doubles; the filters alone answer nothing when they
// are not sure.

#include <graze/narrowphase/predicates/predicates.h>
#include <optional>
#include <utility>

namespace graze::narrowphase {

/// The vector to - from, between arrays of three doubles.
struct Step {
  const double* from;
  const double* to;
};

constexpr Step operator-(Step step) {
  return {step.to, step.from};
}

/// Return the sign of p . q.
std::optional<Sign> dot_filter(Step p, Step q);
Sign sign_of_dot(Step p, Step q);

/// Return the sign of (p x q) . r.
std::optional<Sign> triple_filter(Step p, Step q, Step r);
Sign sign_of_triple(Step p, Step q, Step r);

/// A product, rounded, off by at most `bound`, which is infinite where nothing is known.
struct RoundedTriple {
  double value;
  double bound;
};
/// Returns (p x q) . r and (p x q) . s.
std::pair<RoundedTriple, RoundedTriple> rounded_triples(Step p, Step q, Step r, Step s);

/// Returns a bound of what such a product is off by if no component of p and r is larger than that;
/// infinite where nothing is known.
double triple_bound(double largest_of_p, Step q, double largest_of_r);
double triple_bound(double largest_of_p, double largest_of_q, double largest_of_r);

/// Return the sign of (p x q) . (r x s).
std::optional<Sign> crosses_filter(Step p, Step q, Step r, Step s);
Sign sign_of_cross_products(Step p, Step q, Step r, Step s);

}  // namespace graze::narrowphase
