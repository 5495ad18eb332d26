#pragma once

#include <graze/bvh/build/reference.h>
#include <graze/bvh/refit/degradation.h>

namespace graze::bvh {

/// References in the order of a tree's primitives, in the frame around them.
struct FittedReferences {
  LocalFrame frame;
  References references;
};

/// Makes references to the boxes in the order of the tree's primitives. Throws as refit() does.
FittedReferences fitted_references(const Tree& tree, std::span<const Aabb> boxes);

/// Does what refit() does with references to boxes that are known to be valid, in a frame around
/// them: in the order of the tree's primitives.
void refit(Tree& tree, std::span<const Reference> references, const LocalFrame& frame);

/// Does what refit_and_rebuild() does, with such references.
std::size_t refit_and_rebuild(Tree& tree, std::vector<float>& costs,
                              std::span<const Reference> references, const LocalFrame& frame,
                              const RebuildSettings& settings = {});

}  // namespace graze::bvh
