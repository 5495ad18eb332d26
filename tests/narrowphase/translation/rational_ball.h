#pragma once

// Law 13 of a ball and a triangle, by going through time: between the times at which the nearest
// feature can change, which are rational, the squared distance is one polynomial of degree two. The
// library asks each feature for a root, whatever the others do.

#include <graze/bvh/sphere.h>
#include <graze/narrowphase/first_contact.h>
#include <graze/narrowphase/triangle.h>

#include <gmpxx.h>

#include <optional>

namespace graze::oracle {

/// The smaller root of a t^2 + b t + c if a is positive, else the time -c.
struct QuadraticTime {
  mpq_class a, b, c;

  /// The sign of x less this time.
  int compare(const mpq_class& x) const;
  /// To more digits than times of different roots of the tests have in common.
  mpf_class value() const;
};

/// The answer, and the exact time.
struct RationalBallCast {
  std::optional<FirstContact> contact;
  QuadraticTime time;
};

RationalBallCast rational_cast(const Triangle& triangle, const Sphere& ball,
                               const Eigen::Vector3d& d, StartContact start);

}  // namespace graze::oracle
