#pragma once

// Two hulls whose points go straight are no further apart than a clearance s while some pair of
// their features is: a corner and a corner, an edge or the face, or two edges, each without the
// features that bound it. The squared distance of two points, of a point from a line or a plane, or
// of two lines, less s^2, is a quotient of polynomials in time, and so is where the foot is.

#include <graze/narrowphase/motion/long_polynomial.h>
#include <graze/narrowphase/motion/paths.h>

#include <vector>

namespace graze::narrowphase {

/// A pair of features. They are no further apart than s where `size` is positive, `gap` is not, and
/// no number of `inside` is negative.
struct NearFeature {
  LongPolynomial gap;   ///< the squared distance less s^2, times the size; of degree six at most
  LongPolynomial size;  ///< the squared length of an edge, a face's normal or a common normal; 1
                        ///< for two corners
  std::vector<LongPolynomial> inside;  ///< polynomials that say where the feet are, of degree four
                                       ///< at most
};

/// Returns all pairs. The clearance is finite and not negative.
std::vector<NearFeature> near_features_of(const FourPaths& paths, double clearance);

}  // namespace graze::narrowphase
