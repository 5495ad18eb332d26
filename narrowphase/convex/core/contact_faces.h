#pragma once

// Finds which polygons of a hull's corners count as its faces where contacts are concerned.

#include <graze/narrowphase/convex/core/hull.h>

namespace graze::narrowphase {

/// Corners this share of the hull's bounding radius below a face's plane lie in the face, for
/// contacts: less than half of kDepthTolerance, to which depths are promised, and above what
/// coordinates that were once rounded to float are off by, 2^-24 of that radius, even where three
/// such points span a plane that a fourth misses by several times as much.
inline constexpr double kContactFlatness = 0x1p-21;

/// Fills in `contact_faces`, their offsets and their loops. From the largest facet to the smallest,
/// each that no polygon has taken makes one: of all corners that lie within kContactFlatness of its
/// plane. The plane is the facet's own, so that no point of the hull is in front of it; the polygon
/// is a convex one of corners, so that it lies in the hull, and nowhere further than the flatness
/// behind the plane. It takes facets whose corners are all among its own and whose normals are
/// within 8 degrees. Takes O(f v) for f facets and v corners.
void add_contact_faces(Hull& hull);

}  // namespace graze::narrowphase
