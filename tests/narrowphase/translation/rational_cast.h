#pragma once

// Law 13 by duality, in integers, while the library looks for features that meet: B moved by t d
// meets A if and only if t d is a difference of points of A and B, and these are what satisfies
// lowest <= n . x <= highest, over the differences of corners, for all n across two of their edges
// or one of these and an axis, and for the axes.

#include <graze/bvh/aabb.h>
#include <graze/narrowphase/first_contact.h>
#include <graze/narrowphase/triangle.h>

#include <gmpxx.h>

#include <string>

namespace graze::oracle {

/// The answer, and the exact time.
struct RationalCast {
  std::optional<FirstContact> contact;
  mpq_class time;
};

RationalCast rational_cast(const Triangle& a, const Triangle& b, const Eigen::Vector3d& d,
                           StartContact start);

/// Of a solid box; a contact at the start counts.
RationalCast rational_cast(const Triangle& a, const Aabb& box, const Eigen::Vector3d& d);

/// The largest double that is not above a number in [0, 1].
double floor_of(const mpq_class& time);

/// All digits, for messages.
std::string text_of(const Triangle& triangle);
std::string text_of(const Eigen::Vector3d& point);

}  // namespace graze::oracle
