#pragma once

#include <graze/engine/mesh/mesh.h>
#include <graze/engine/work.h>

namespace graze {

/// Builds now, with all threads, what pair queries would build of the mesh's tree as they walk it,
/// so that none of them has to: for programs that ask much, or must answer the first query as fast
/// as the next. Changes no answer. What is built already, by this or by queries, is not built
/// again; safe to call from many threads, beside queries too. Counts what it built in `work`. The
/// binary tree, which distance(), self queries and other volumes walk, is Mesh::tree(). O(n log n).
void prepare(const Mesh& mesh, Work* work = nullptr);

}  // namespace graze
