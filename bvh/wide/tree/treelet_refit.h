#pragma once

#include <graze/bvh/wide/tree/corner_source.h>
#include <graze/bvh/wide/tree/wide_tree.h>

#include <cstdint>
#include <optional>
#include <span>

namespace graze::bvh {

/// Returns the stock's nodes fitted to where the same primitives, in the same order, are now: along
/// the axes that they have or, where these no longer fit, along new ones. Returns nothing if the
/// nodes have degraded: if boxes have grown into each other so far that they are better built anew.
/// It takes linear time in primitives times levels.
std::optional<Treelet> refitted_treelet(const Treelet& stock, const TreeletPart& part,
                                        std::span<const std::uint32_t> order,
                                        const LocalFrame& frame, const CornerSource& source);

}  // namespace graze::bvh
