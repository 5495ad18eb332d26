#pragma once

#include <graze/engine/mesh/mesh.h>
#include <graze/engine/work.h>

namespace graze {

/// The queries that are to find nothing left to build.
enum class PreparedFor {
  Pairs,  ///< queries on two meshes, with or without a PairMemory, by PairVolume::WideObb
  All,    ///< these, and those that walk the binary tree: rays, casts of boxes and balls, points
          ///< inside, voxels, a mesh with itself, the contacts of bodies
};

/// The settings of prepare().
struct PrepareSettings {
  PreparedFor queries = PreparedFor::Pairs;  ///< the queries that shall find nothing left to build
};

/// Builds now, with all threads, what queries would build of the mesh's trees as they walk them, so
/// that none of them has to: for programs that ask much, or must answer the first query as fast as
/// the next. It changes no answer. What is built already, by this or by queries, is not built
/// again; it may be called from many threads, beside queries too. It takes O(n log n). Counts what
/// it built in `work`.
void prepare(const Mesh& mesh, const PrepareSettings& settings = {}, Work* work = nullptr);

}  // namespace graze
