#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <graze/engine/mesh/pair.h>

namespace graze {

/// One connected piece of an intersection of two surfaces, for a simulation.
struct MeshContact {
  Eigen::Vector3d point;      ///< midway between `point_a` and `point_b`, metres
  Eigen::Vector3d point_a;    ///< the point of A that is deepest in B, along the normal
  Eigen::Vector3d point_b;    ///< the point of B that is deepest in A, against the normal
  Eigen::Vector3d normal;     ///< a unit vector, to 2 ulp, from A to B
  double depth;               ///< metres, >= 0
  std::uint32_t first_point;  ///< the first corner of its intersection in MeshContacts::points
  std::uint32_t point_count;  ///< how many corners it has

  bool operator==(const MeshContact&) const = default;
};

/// The result of find_contacts() for two meshes.
struct MeshContacts {
  std::vector<MeshContact> contacts;                   ///< the deepest first; ties by their points
  std::vector<Eigen::Vector3d> points;                 ///< the corners of each contact, ascending
                                                       ///< lexicographically
  Completeness completeness = Completeness::Complete;  ///< LimitReached if there are more contacts

  std::size_t size() const { return contacts.size(); }
  bool empty() const { return contacts.empty(); }
  auto begin() const { return contacts.begin(); }
  auto end() const { return contacts.end(); }
  const MeshContact& operator[](std::size_t index) const { return contacts[index]; }
  /// Returns the corners of the intersection that a contact stands for.
  std::span<const Eigen::Vector3d> points_of(const MeshContact& contact) const {
    return {points.data() + contact.first_point, contact.point_count};
  }

  bool operator==(const MeshContacts&) const = default;
};

/// Returns one contact for each connected piece of find_intersection(): a loop, several loops and
/// patches that meet, or a touching point. The list is empty exactly when intersects() is false; a
/// mesh inside another has no contact with it. The sense of the triangles says what is inside: they
/// turn counter-clockwise as seen from outside.
///
/// find_contacts() of shapes (manifold.h), `{Shape(bolt)}` for a mesh, answers another question:
/// what a solver of a simulation needs, up to four contacts of each region that is left in one
/// direction. Here one contact stands for a whole piece of the intersection.
///
/// **Normal.** The normal is the direction of the area vector of the piece's loops and patches:
/// that in which the surfaces are apart soonest if they are nearly flat there. Where it vanishes,
/// as for surfaces that touch along a line or in a point, it is the difference of the mean face
/// normals of A and of B, or the normal of the one face, or of the two edges, that touch; where
/// that vanishes too, it is the direction from the middle of A to that of B.
///
/// **Depth.** The depth is local, and is that of the surfaces: the parts of A inside B and of B
/// inside A that end at this piece reach past each other along the normal by a width, from
/// `point_b` to `point_a`. The depth is that width, or less if all of B is past A sooner: moving B
/// by the depth along the normal takes the two parts out of each other, but for rounding. It is not
/// the smallest translation, and other parts may still meet: separating_translation() says for all.
/// Where a piece encloses nothing (a curve ends where an open mesh does, or leads around a handle),
/// only the triangles that cross count. For touching along a plane, a line or in a point the depth
/// is 0, but for rounding.
///
/// **Errors.** Points are placed vertices or corners of the intersection, off by at most 2 ulp of
/// the largest placed coordinate, `point` by one more (law 7). The depth, given the normal, is less
/// than the exact one by at most 16 ulp of it, and more by at most that or by what
/// separating_translation() adds to a last contact. Swapping A and B gives the same contacts with
/// opposite normals and `point_a` and `point_b` swapped, bit for bit (law 4), unless the meshes are
/// the same in the same pose. Throws as separating_translation() does.
MeshContacts find_contacts(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                           const ContactSettings& settings = {}, Work* work = nullptr);

}  // namespace graze
