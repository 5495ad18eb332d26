#pragma once

// This is private to the library.

#include <graze/engine/mesh/mesh.h>
#include <graze/narrowphase/predicates/predicates.h>

#include <cstdint>
#include <span>

namespace graze {

/// Returns the sign of the volume that some triangles of a mesh enclose, exactly: Positive where
/// they turn counter-clockwise as seen from outside. As many of them must go along each edge one
/// way as the other, so that the volume does not depend on an origin.
narrowphase::Sign volume_sign(const Mesh& mesh, std::span<const std::uint32_t> triangles);

}  // namespace graze
