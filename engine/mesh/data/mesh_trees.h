#pragma once

// Queries walk these parts of a mesh: each is made by whoever asks for it first, and shared by all
// handles to the mesh. They are private to the library.

#include <graze/engine/mesh/mesh.h>

#include <span>

namespace graze {

namespace bvh {
struct Tree;
class WideTree;
struct FloatSphere;
struct FloatObb;
struct FloatKDop;
}  // namespace bvh
struct VertexFans;
struct Work;

/// Returns the hierarchy over the triangles. It is built when first asked for, in O(n log n), or,
/// for a deformed mesh, fitted to the one before. The call that does it counts that in `work`.
const bvh::Tree& tree_of(const Mesh& mesh, Work* work = nullptr);

/// Returns the same hierarchy in wide nodes, whose parts are built when a query first walks them.
const bvh::WideTree& wide_tree_of(const Mesh& mesh, Work* work = nullptr);

/// True if anything of either has been built, by whoever asked. It builds nothing, and takes O(1).
bool has_tree(const Mesh& mesh);

/// Return the skins of the tree: one volume for each of its nodes, in the tree's frame. They are
/// fitted when first asked for, in O(n log n), which the call that does it counts in `work`.
std::span<const bvh::FloatSphere> sphere_skin_of(const Mesh& mesh, Work* work = nullptr);
std::span<const bvh::FloatObb> obb_skin_of(const Mesh& mesh, Work* work = nullptr);
std::span<const bvh::FloatKDop> kdop_skin_of(const Mesh& mesh, Work* work = nullptr);

/// Returns the triangles around each welded vertex. They are found when first asked for, in O(n log
/// n).
const VertexFans& vertex_fans_of(const Mesh& mesh);

}  // namespace graze
