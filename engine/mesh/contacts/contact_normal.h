#pragma once

#include <graze/engine/mesh/curves/regions.h>
#include <graze/engine/mesh/sweep/sweep.h>

namespace graze::contacts {

/// The unit normal of a region, from A to B, by the first of these that there is:
/// 1. the area vector of its loops and patches. A loop runs along (normal of A) x (normal of B), by
///    the sum over its segments, so that its area vector points to where B is outside of A; a patch
///    counts as far as the normals of A and B oppose each other. It must be 16 times its error.
/// 2. the mean of A's face normals minus that of B's along its segments and at its points; where
///    one side of these is a single triangle, its normal alone; where insides of edges cross in a
///    point, the normal of both edges.
/// 3. from the middle of A's bounds to that of B's; or from the mesh that comes first in an order
///    by coordinates to the other, along x.
/// Swapping A and B turns it round bit for bit, unless the meshes are alike in all they are.
Eigen::Vector3d contact_normal(const CellComplex& complex, const std::vector<CurveSteps>& curves,
                               const Region& region, const PlacedMeshView& a,
                               const PlacedMeshView& b, const SweepUnits& units);

}  // namespace graze::contacts
