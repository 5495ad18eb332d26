#pragma once

#include <memory>

#include <graze/engine/compare/peers/engine.h>

namespace graze::compare {

/// Loads two shapes of bodies as two meshes are loaded, so that many poses are asked about one
/// after the other. Engines other than graze are asked what their adaptors know; returns null for
/// one that knows no shapes.
std::unique_ptr<LoadedPair> load_shape_pair(const Engine& engine, const Shape& shape_a,
                                            const Shape& shape_b);

}  // namespace graze::compare
