#include "tests/engine/first_touch/questions.h"

#include <graze/bvh/fit/kdop_fit.h>
#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/containment.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/data/vertex_fans.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/fit.h>
#include <graze/engine/mesh/mesh_contacts.h>
#include <graze/engine/mesh/mesh_intersection.h>
#include <graze/engine/mesh/mesh_ray.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/pair_memory.h>
#include <graze/engine/mesh/pose_batch.h>
#include <graze/engine/mesh/prepare.h>
#include <graze/engine/mesh/self.h>
#include <graze/engine/mesh/separating_translation.h>
#include <graze/engine/mesh/volume_query.h>
#include <graze/engine/mesh/voxels.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shape_ray.h>
#include <graze/engine/world/world.h>

#include "tests/engine/first_touch/motion_questions.h"
#include "tests/shapes/pose_at.h"

namespace graze::tests {
namespace {

/// They touch there, and are apart there.
Pose near() {
  return at(0.3, 0.1, 0.2);
}
Pose far() {
  return at(2.5, 0.1, 0.2);
}

Digest told(const TrianglePairs& pairs) {
  Digest digest;
  for (const TrianglePair& pair : pairs)
    digest << pair.a << pair.b;
  return digest << pairs.completeness;
}

Digest told(const MeshDistance& found) {
  return Digest() << found.distance << found.point_a << found.point_b << found.pair.a
                  << found.pair.b;
}

Digest told(const TriangleList& list) {
  Digest digest;
  for (const std::uint32_t triangle : list)
    digest << triangle;
  return digest << list.completeness;
}

Digest told(const std::vector<RayHit>& hits) {
  Digest digest;
  for (const RayHit& hit : hits)
    digest << hit.distance << hit.point << hit.normal << hit.triangle;
  return digest;
}

Digest told(const Voxels& voxels) {
  Digest digest;
  for (const Voxel& voxel : voxels)
    digest << voxel.i << voxel.j << voxel.k;
  return digest << voxels.grid.origin << voxels.grid.edge;
}

template <PairVolume kVolume>
Digest pairs_by(const Mesh& a, const Mesh& b) {
  return told(find_triangle_pairs({a}, {b, near()}, {.volume = kVolume}));
}

template <PairVolume kVolume>
Digest any_by(const Mesh& a, const Mesh& b) {
  return Digest() << intersects({a}, {b, near()}, {.volume = kVolume})
                  << intersects({a}, {b, far()}, {.volume = kVolume});
}

Digest shared_pairs(const Mesh& a, const Mesh& b) {
  return told(find_triangle_pairs({a}, {b, near()}, {.threads = 0}));
}

Digest solid(const Mesh& a, const Mesh& b) {
  return Digest() << intersects({a}, {b, far()}, {.hit = Hit::Solid});
}

Digest crossing(const Mesh& a, const Mesh& b) {
  return told(find_triangle_pairs({a}, {b, near()}, {.touch = Touch::Exclude}));
}

Digest distances(const Mesh& a, const Mesh& b) {
  return told(distance({a}, {b, far()}));
}

Digest clearance(const Mesh& a, const Mesh& b) {
  return Digest() << within({a}, {b, far()}, 0.1) << within({a}, {b, far()}, 1);
}

Digest remembered(const Mesh& a, const Mesh& b) {
  PairMemory memory;
  Digest digest;
  for (int i = 0; i < 4; ++i) {
    const Pose pose = at(2.2 - 0.1 * i, 0.1, 0.2);
    const MeshDistance apart = distance({a}, {b, pose}, memory);
    digest << intersects({a}, {b, pose}, memory) << apart.distance << apart.pair.a;
  }
  return digest;
}

Digest batch(const Mesh& a, const Mesh& b) {
  const std::vector<Pose> poses = {near(), far(), at(0, 0, 3)};
  Digest digest;
  for (const bool hit : intersects({a}, {b, poses}))
    digest << hit;
  for (const MeshDistance& found : distance({a}, {b, poses}))
    digest << found.distance << found.point_a;
  return digest;
}

Digest contacts(const Mesh& a, const Mesh& b) {
  Digest digest;
  for (const MeshContact& contact : find_contacts({a}, {b, near()}))
    digest << contact.point << contact.normal << contact.depth;
  return digest;
}

Digest intersection(const Mesh& a, const Mesh& b) {
  Digest digest;
  const MeshIntersection found = find_intersection({a}, {b, near()});
  for (const IntersectionPoint& point : found.points)
    digest << point.position;
  return digest << found.curves.size() << found.patches.size();
}

Digest separation(const Mesh& a, const Mesh& b) {
  const SeparatingTranslation along = separating_translation({a}, {b, near()}, {0, 0, 1});
  const SeparatingTranslation any = separating_translation({a}, {b, near()});
  return Digest() << along.distance << along.translation << any.distance << any.translation;
}

Digest itself(const Mesh& a, const Mesh& b) {
  Digest digest = told(find_self_pairs(b, {.kind = SelfPairKind::Neighbour}));
  return digest << self_intersects(a);
}

template <typename Shape>
Digest met_by(const Mesh& a, const Shape& shape) {
  Digest digest = told(find_triangles({a, near()}, shape));
  return digest << intersects({a, near()}, shape);
}

Digest box(const Mesh& a, const Mesh& /*b*/) {
  return met_by(a, Aabb{{0, 0, 0}, {1, 1, 1}});
}

Digest obb(const Mesh& a, const Mesh& /*b*/) {
  return met_by(a, Obb{near(), {0.5, 0.5, 0.5}});
}

Digest ball(const Mesh& a, const Mesh& /*b*/) {
  return met_by(a, Sphere{{0.5, 0, 0}, 0.75});
}

Digest rays(const Mesh& a, const Mesh& b) {
  Digest digest;
  if (const auto first = cast_ray({a}, Ray{{-5, 0.1, 0.2}, {1, 0, 0}})) digest = told({*first});
  return digest << told(cast_ray_all({b}, Ray{{-5, 0.1, 0.2}, {1, 0, 0}})).size();
}

Digest inside(const Mesh& a, const Mesh& b) {
  return Digest() << contains(a, {0.1, 0.2, 0.3}) << contains(b, {3, 3, 3});
}

Digest surface_voxels(const Mesh& a, const Mesh& /*b*/) {
  return told(find_voxels(a, {.resolution = 12}));
}

Digest solid_voxels(const Mesh& a, const Mesh& /*b*/) {
  return told(find_voxels(a, {.resolution = 12, .fill = VoxelFill::Solid}));
}

Digest bounds(const Mesh& a, const Mesh& b) {
  return Digest() << a.bounds().min << a.bounds().max << b.bounds().min << b.bounds().max;
}

Digest topology(const Mesh& a, const Mesh& b) {
  Digest digest;
  for (const Mesh& mesh : {a, b}) {
    const Topology& found = mesh.topology();
    digest << found.welded_vertices << found.components << found.degenerate_triangles
           << found.duplicate_triangles << found.boundary_edges << found.is_closed;
    for (const std::uint32_t vertex : mesh.component_vertices())
      digest << vertex;
  }
  return digest;
}

Digest welded(const Mesh& a, const Mesh& /*b*/) {
  Digest digest;
  for (const std::uint32_t vertex : a.welded())
    digest << vertex;
  return digest;
}

Digest fans(const Mesh& a, const Mesh& /*b*/) {
  Digest digest;
  for (const std::uint32_t triangle : vertex_fans_of(a).triangles)
    digest << triangle;
  for (const std::uint32_t first : vertex_fans_of(a).first)
    digest << first;
  return digest;
}

Digest volumes(const Mesh& a, const Mesh& /*b*/) {
  const Sphere sphere = bounding_sphere(a);
  const Obb obb = bounding_obb(a);
  Digest digest;
  digest << sphere.centre << sphere.radius << obb.half_extents << signed_volume(a);
  for (const VolumeFit& fit : measure_fit(a).volumes)
    digest << fit.volume << fit.surface;
  return digest;
}

Digest tree(const Mesh& a, const Mesh& /*b*/) {
  const Digest walked = box(a, a);
  Digest digest;
  digest << tree_of(a).nodes.size() << has_tree(a);
  return digest << (walked == box(a, a));
}

Digest skins(const Mesh& a, const Mesh& /*b*/) {
  Digest digest;
  digest << sphere_skin_of(a).size() << obb_skin_of(a).size() << kdop_skin_of(a).size();
  return digest;
}

Digest prepared(const Mesh& a, const Mesh& b) {
  prepare(a), prepare(b);
  return told(find_triangle_pairs({a}, {b, near()}));
}

Digest shapes(const Mesh& a, const Mesh& b) {
  const Shape shape(a), other(b), drum(Cylinder{0.4, 0.6});
  Digest digest;
  for (const Pose& pose : {near(), far()}) {
    const ShapeDistance apart = distance({shape, at(0)}, {drum, pose});
    digest << intersects({shape, at(0)}, {other, pose}) << apart.distance << apart.point_a;
    for (const ShapeContact& contact : find_contacts({shape, at(0)}, {other, pose}))
      digest << contact.depth << contact.normal;
  }
  if (const auto hit = cast_ray({shape, near()}, Ray{{-5, 0.1, 0.2}, {1, 0, 0}}))
    digest << hit->distance;
  return digest;
}

Digest worlds(const Mesh& a, const Mesh& b) {
  World world;
  world.add({a, at(0)}), world.add({b, near()}), world.add({a, far()}),
      world.add({Box{{1, 1, 1}}, at(1)});
  const WorldUpdate update = world.update();
  Digest digest;
  for (const BodyContact& contact : update.contacts) {
    digest << contact.pair.a.index << contact.pair.b.index;
    for (const ShapeContact& point : contact.manifold)
      digest << point.depth << point.normal;
  }
  return digest;
}

constexpr FirstQuestion kQuestions[] = {
    {"any, wide", any_by<PairVolume::WideObb>},
    {"any, boxes", any_by<PairVolume::Aabb>},
    {"any, spheres", any_by<PairVolume::Sphere>, WorkedOutBy::OneTbbToo},
    {"any, oriented boxes", any_by<PairVolume::Obb>, WorkedOutBy::OneTbbToo},
    {"any, k-DOPs", any_by<PairVolume::KDop>, WorkedOutBy::OneTbbToo},
    {"pairs, wide", pairs_by<PairVolume::WideObb>},
    {"pairs, boxes", pairs_by<PairVolume::Aabb>},
    {"pairs, spheres", pairs_by<PairVolume::Sphere>, WorkedOutBy::OneTbbToo},
    {"pairs, oriented boxes", pairs_by<PairVolume::Obb>, WorkedOutBy::OneTbbToo},
    {"pairs, k-DOPs", pairs_by<PairVolume::KDop>, WorkedOutBy::OneTbbToo},
    {"pairs, shared by threads", shared_pairs, WorkedOutBy::OneTbbToo},
    {"solids", solid},
    {"pairs that cross", crossing},
    {"distance", distances},
    {"within", clearance},
    {"with a memory", remembered},
    {"many poses", batch, WorkedOutBy::OneTbbToo},
    {"contacts", contacts},
    {"intersection", intersection},
    {"separation", separation},
    {"with itself", itself},
    {"on the way", on_the_way, WorkedOutBy::OneTbbToo},
    {"in rigid motion", in_motion},
    {"certified", certified},
    {"many motions", many_motions, WorkedOutBy::OneTbbToo},
    {"going straight", straight},
    {"a box", box},
    {"an oriented box", obb},
    {"a ball", ball},
    {"rays", rays},
    {"a point inside", inside},
    {"voxels of the surface", surface_voxels, WorkedOutBy::OneTbbToo},
    {"voxels of the solid", solid_voxels, WorkedOutBy::OneTbbToo},
    {"bounds", bounds},
    {"topology", topology},
    {"welded vertices", welded},
    {"fans of vertices", fans},
    {"volumes around it", volumes},
    {"binary tree", tree},
    {"skins", skins, WorkedOutBy::OneTbbToo},
    {"prepare", prepared, WorkedOutBy::OneTbbToo},
    {"shapes", shapes},
    {"worlds", worlds},
};

}  // namespace

std::span<const FirstQuestion> first_questions() {
  return kQuestions;
}

}  // namespace graze::tests
