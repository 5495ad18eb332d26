#pragma once

#include <graze/engine/mesh/placed_mesh.h>

#include <string>

namespace graze::cli {

/// Returns an SVG file of the place where two meshes meet, or are nearest to each other, from two
/// sides: A blue and B orange, with the triangles of each that are nearest to it.
std::string contact_picture(const PlacedMeshView& a, const PlacedMeshView& b);

}  // namespace graze::cli
