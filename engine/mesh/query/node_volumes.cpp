#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/query/node_volumes.h>

namespace graze {
namespace {

bool needs_spheres(Volume volume) {
  return volume != Volume::Wide && volume != Volume::Aabb && volume != Volume::Obb &&
         volume != Volume::KDop;
}

bool needs_obbs(Volume volume) {
  return volume == Volume::Obb || volume == Volume::SphereThenObb;
}

bool needs_kdops(Volume volume) {
  return volume == Volume::KDop || volume == Volume::SphereThenKDop;
}

}  // namespace

NodeVolumes volumes_of(const Mesh& mesh, Volume volume, Work& work) {
  name_of(volume);  // throws for what is none
  NodeVolumes volumes;
  volumes.nodes = mesh.tree(&work).nodes;
  if (needs_spheres(volume)) volumes.spheres = mesh.sphere_skin(&work);
  if (needs_obbs(volume)) volumes.obbs = mesh.obb_skin(&work);
  if (needs_kdops(volume)) volumes.kdops = mesh.kdop_skin(&work);
  return volumes;
}

}  // namespace graze
