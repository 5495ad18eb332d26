#pragma once

#include <graze/bvh/sphere.h>
#include <graze/narrowphase/first_contact.h>
#include <graze/narrowphase/triangle.h>

namespace graze {

/// Says how cast() treats a contact at t = 0.
struct CastSettings {
  StartContact start = StartContact::Counts;  ///< says whether a contact at t = 0 counts
};

/// Returns when triangle B, moved by `t displacement` (metres, t in [0, 1]), first meets triangle
/// A, which stays, or nothing if it never does (law 13). The answer is that of real arithmetic on
/// the given doubles, for every finite input: triangles that slide in one plane, touch in passing,
/// have no area, are huge or tiny; a displacement of zero asks whether they meet where they are.
/// The time is never late, and it is early by less than the distance of two doubles. Swapping A and
/// B along the opposite displacement, and the order of corners, change nothing.
///
/// With StartContact::IsLeft triangles that meet at t = 0 count only if they cross (crosses())
/// there or directly afterwards, and then at t = 0: what rests on a surface, slides along it or
/// leaves it goes on, what goes into it does not. As times of contact of two convex sets hang
/// together, such triangles meet no more later.
///
/// Takes a few hundred nanoseconds. Throws InputError for a coordinate or a component that is not
/// finite.
///
/// The least time is the optimum of a linear program, whose basic solutions are the contacts of a
/// corner and a face and of two edges in Boyse, "Interference detection among solids and surfaces",
/// Communications of the ACM 22(1), 1979.
std::optional<FirstContact> cast(const Triangle& triangle_a, const Triangle& triangle_b,
                                 const Eigen::Vector3d& displacement,
                                 const CastSettings& settings = {});

/// Returns when a closed ball, moved by `t displacement` (metres, t in [0, 1]), first meets a
/// triangle, which stays, or nothing if it never does (law 13). The answer is that of real
/// arithmetic on the given doubles, for every finite input: a ball may touch in passing, at a time
/// that is no double, have a radius of 0, be huge or tiny, and the triangle may have no area. The
/// time is never late, and it is early by less than the distance of two doubles. To move the
/// triangle instead, give the opposite displacement; the order of corners changes nothing.
///
/// With StartContact::IsLeft a ball that meets the triangle at t = 0 does so only if its inside
/// does then, or directly afterwards: what rests on a triangle, rolls along it or leaves it goes
/// on, what goes into it does not.
///
/// Takes a tenth of a microsecond where they are surely apart all the way, else some tens. Throws
/// InputError for a coordinate or a component that is not finite, and for a negative radius.
///
/// The squared distance of a point on a straight path from a triangle is convex, and made of pieces
/// of degree two: one for each feature that is nearest (Ericson, Real-Time Collision Detection,
/// 2005, section 5.5.6, has spheres that go straight).
std::optional<FirstContact> cast(const Triangle& triangle, const Sphere& ball,
                                 const Eigen::Vector3d& displacement,
                                 const CastSettings& settings = {});

}  // namespace graze
