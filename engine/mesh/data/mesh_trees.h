#pragma once

// What queries walk of a mesh: each part is made by whoever asks for it first, and shared by all
// handles to the mesh. Private to the library.

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

/// The hierarchy over the triangles, built when first asked for, O(n log n), or, of a deformed
/// mesh, fitted to the one before. The call that does it counts that in `work`.
const bvh::Tree& tree_of(const Mesh& mesh, Work* work = nullptr);

/// The same hierarchy in wide nodes, whose parts are built when a query first walks them.
const bvh::WideTree& wide_tree_of(const Mesh& mesh, Work* work = nullptr);

/// Whether anything of either has been built, by whoever asked. Builds nothing; O(1).
bool has_tree(const Mesh& mesh);

/// The skins of the tree: one volume for each of its nodes, in the tree's frame. Fitted when first
/// asked for, O(n log n), which the call that does it counts in `work`.
std::span<const bvh::FloatSphere> sphere_skin_of(const Mesh& mesh, Work* work = nullptr);
std::span<const bvh::FloatObb> obb_skin_of(const Mesh& mesh, Work* work = nullptr);
std::span<const bvh::FloatKDop> kdop_skin_of(const Mesh& mesh, Work* work = nullptr);

/// The triangles around each welded vertex. Computed when first asked for, O(n log n).
const VertexFans& vertex_fans_of(const Mesh& mesh);

}  // namespace graze
