#pragma once

#include <graze/bvh/build/build.h>
#include <graze/bvh/build/part.h>
#include <vector>

namespace graze::bvh {

/// The nodes of a tree above parts whose subtrees are built later, or never. A leaf among the nodes
/// is a part: its `first` counts parts, its `count` primitives.
struct TopTree {
  std::vector<Node> nodes;  ///< nodes[0] is the root; children side by side behind their parent
  std::vector<Part> parts;
};

/// Splits all references down to parts of at most `part_size`, or larger ones where leaves may be
/// larger, and puts the references of each side by side. With build_subtree() of the parts this is
/// the same tree for any part size. `depth` nodes lie above the root. It is parallel; the result is
/// the same for any number of threads.
TopTree split_top(std::span<Reference> references, std::size_t part_size,
                  const BuildSettings& settings, int depth = 0);

}  // namespace graze::bvh
