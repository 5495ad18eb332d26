#pragma once

// Queries compare these volumes, whichever they are asked to use. They are private to engine/mesh.

#include <graze/bvh/skins/kdop_separation.h>
#include <graze/bvh/skins/node_separation.h>
#include <graze/bvh/skins/obb_separation.h>
#include <graze/bvh/skins/sphere_separation.h>
#include <graze/bvh/volume.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/work.h>

#include <span>

namespace graze {

/// The volumes over the nodes of one tree: the nodes' own boxes and those skins that a query needs.
struct NodeVolumes {
  std::span<const bvh::Node> nodes;
  std::span<const bvh::FloatSphere> spheres;
  std::span<const bvh::FloatObb> obbs;
  std::span<const bvh::FloatKDop> kdops;
};

/// Returns what `volume` needs of a mesh, which is made if this is the first time that it is
/// needed.
NodeVolumes volumes_of(const Mesh& mesh, Volume volume, Work& work);

/// Calls `use(separation)` with what proves nodes of A and B apart by `volume`.
template <typename Use>
void with_separation(Volume volume, const bvh::RelativeFrame& frame, const NodeVolumes& a,
                     const NodeVolumes& b, Use&& use) {
  const auto boxes = [&] { return bvh::NodeSeparation(frame, a.nodes, b.nodes); };
  const auto spheres = [&] { return bvh::SphereSeparation(frame, a.spheres, b.spheres); };
  const auto obbs = [&] { return bvh::ObbSeparation(frame, a.obbs, b.obbs); };
  const auto kdops = [&] { return bvh::KDopSeparation(frame, a.kdops, b.kdops); };
  switch (volume) {
    case Volume::Aabb:
      return use(boxes());
    case Volume::Sphere:
      return use(spheres());
    case Volume::Obb:
      return use(obbs());
    case Volume::KDop:
      return use(kdops());
  }
}

/// A separation that counts what it is asked and what it prunes.
template <typename Separation>
class CountedSeparation {
 public:
  CountedSeparation(const Separation& separation, Work& work)
      : separation_(separation), work_(work) {}

  bool are_apart(std::uint32_t a, std::uint32_t b) const {
    ++work_.volume_tests;
    const bool is_pruned = separation_.are_apart(a, b);
    work_.volume_rejections += is_pruned;
    return is_pruned;
  }
  bool is_first_larger(std::uint32_t a, std::uint32_t b) const {
    return separation_.is_first_larger(a, b);
  }

 private:
  const Separation& separation_;
  Work& work_;
};

}  // namespace graze
