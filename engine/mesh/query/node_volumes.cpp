#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/query/node_volumes.h>

namespace graze {

NodeVolumes volumes_of(const Mesh& mesh, Volume volume, Work& work) {
  name_of(volume);  // throws for a value that is no volume
  NodeVolumes volumes;
  volumes.nodes = tree_of(mesh, &work).nodes;
  if (volume == Volume::Sphere) volumes.spheres = sphere_skin_of(mesh, &work);
  if (volume == Volume::Obb) volumes.obbs = obb_skin_of(mesh, &work);
  if (volume == Volume::KDop) volumes.kdops = kdop_skin_of(mesh, &work);
  return volumes;
}

}  // namespace graze
