#pragma once

#include <graze/bvh/skins/float_volumes.h>
#include <graze/bvh/skins/hulls.h>
#include <graze/bvh/tree/tree.h>
#include <vector>

namespace graze::bvh {

// These fit one volume for each node, in the order of the nodes, which holds all primitives below
// it. They are parallel by oneTBB; the result is the same for any number of threads. `hulls` are
// those of the tree.

/// Fits the minimal spheres in O(n log n).
std::vector<FloatSphere> fit_spheres(const Tree& tree, const Hulls& hulls);

/// Fits boxes along the axes of a ditetrahedron, or of the frame where these are no worse, in O(n
/// log n).
std::vector<FloatObb> fit_obbs(const Tree& tree, const Hulls& hulls);

/// Fits the smallest k-DOPs in O(n).
std::vector<FloatKDop> fit_kdops(const Tree& tree, const Hulls& hulls);

}  // namespace graze::bvh
