#pragma once

#include <graze/bvh/ray.h>
#include <graze/engine/mesh/mesh.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace graze::benchmark {

/// A closed ball with bumps of several sizes, of about that many triangles, in no order.
Mesh bumpy_ball(std::uint32_t triangles);

/// Rays of a picture of the mesh, which fills most of it, in blocks of eight by eight.
std::vector<Ray> coherent_rays(const Mesh& mesh, std::size_t count);

/// Rays from points around the mesh to points in its box, at random.
std::vector<Ray> random_rays(const Mesh& mesh, std::size_t count);

}  // namespace graze::benchmark
