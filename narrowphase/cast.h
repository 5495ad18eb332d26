#pragma once

#include <graze/narrowphase/first_contact.h>
#include <graze/narrowphase/triangle.h>

namespace graze {

/// When triangle B, moved by `t displacement` (metres, t in [0, 1]), meets triangle A, which stays,
/// or nothing if it never does (law 13). In real arithmetic on the given doubles, for every finite
/// input: triangles that slide in one plane, touch in passing, have no area, are huge or tiny; a
/// displacement of zero asks whether they meet where they are. The time is never late, and early by
/// less than the distance of two doubles. Swapping A and B along the opposite displacement, and the
/// order of corners, change nothing.
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
                                 const FirstContactSettings& settings = {});

}  // namespace graze
