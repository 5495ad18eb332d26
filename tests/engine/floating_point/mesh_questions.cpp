#include <graze/bvh/skins/float_volumes.h>
#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/placement.h>

#include <cstddef>
#include <span>

#include "tests/engine/floating_point/questions.h"

namespace graze::tests {
namespace {

struct Meshes {
  explicit Meshes(const Inputs& in)
      : a(in.vertices_a, in.triangles_a), b(in.vertices_b, in.triangles_b) {}
  Mesh a, b;
};

void add_distance(Words& words, const MeshDistance& found) {
  words.add(found.distance), words.add(found.point_a), words.add(found.point_b);
  words.add(std::uint64_t{found.pair.a} << 32 | found.pair.b);
}

void add_hit(Words& words, const RayHit& hit) {
  words.add(hit.distance), words.add(hit.point), words.add(hit.normal);
  words.add(std::uint64_t{hit.triangle});
}

void add_separation(Words& words, const SeparatingTranslation& found) {
  words.add(found.distance), words.add(found.direction), words.add(found.translation);
  words.add(found.pose_b);
}

void ask_by_volumes(const Inputs& in, Words& words) {
  for (const PairVolume volume : kPairVolumes) {
    const Meshes meshes(in);
    words.add(intersects({meshes.a, in.pose_a}, {meshes.b, in.pose_b}, {.volume = volume}));
    words.add(
        find_triangle_pairs({meshes.a, in.pose_a}, {meshes.b, in.pose_b}, {.volume = volume}));
    words.add(find_triangle_pairs({meshes.a, in.pose_a}, {meshes.b, in.pose_b},
                                  {.volume = volume, .touch = Touch::Exclude}));
  }
  for (const Volume volume : kVolumes) {
    const Meshes meshes(in);
    words.add(find_triangles({meshes.a, in.pose_a}, in.obb_a, {.volume = volume}));
    words.add(find_self_pairs(meshes.a, {.volume = volume}));
  }
}

void ask_with_memory(const Inputs& in, Words& words) {
  const Meshes meshes(in);
  PairMemory memory;
  for (const Pose& pose : in.poses) {
    const PlacedMesh a{meshes.a, in.pose_a}, b{meshes.b, pose};
    words.add(intersects(a, b, memory)), words.add(find_triangle_pairs(a, b, memory));
    words.add(within(a, b, in.clearance, memory));
    add_distance(words, distance(a, b, memory));
  }
}

void ask_about_volumes(const Inputs& in, Words& words) {
  const Meshes meshes(in);
  const PlacedMesh a{meshes.a, in.pose_a};
  words.add(intersects(a, in.box_a)), words.add(intersects(a, in.obb_a));
  words.add(intersects(a, in.ball_a));
  words.add(intersects(a, in.box_b, {.interior = Interior::Solid}));
  words.add(intersects(a, in.obb_b, {.interior = Interior::Solid}));
  words.add(intersects(a, in.ball_b, {.interior = Interior::Solid}));
  words.add(find_triangles(a, in.box_a)), words.add(find_triangles(a, in.obb_b));
  words.add(find_triangles(a, in.ball_a));
}

void ask_about_contact(const Inputs& in, Words& words) {
  const Meshes meshes(in);
  const PlacedMesh a{meshes.a, in.pose_a}, b{meshes.b, in.pose_b};
  for (const MeshContact& contact : find_contacts(a, b)) {
    words.add(contact.point), words.add(contact.point_a), words.add(contact.point_b);
    words.add(contact.normal), words.add(contact.depth);
  }
  const MeshIntersection found = find_intersection(a, b);
  for (const IntersectionPoint& point : found.points)
    words.add(point.position);
  words.add(std::uint64_t{found.segments.size()}), words.add(std::uint64_t{found.curves.size()});
  words.add(std::uint64_t{found.polygons.size()}), words.add(std::uint64_t{found.patches.size()});
  add_separation(words, separating_translation(a, b, in.direction));
  add_separation(words, separating_translation(a, b));
}

/// Tetrahedra that go through each other may leave no answer.
void ask_for_interiors(const Inputs& in, const Meshes& meshes, Words& words) {
  try {
    words.add(interiors_intersect({meshes.a, in.pose_a}, {meshes.b, in.pose_b}));
  } catch (const MeshError& error) {
    words.add(std::uint64_t{error.place().index.value_or(0)});
  }
}

void ask_about_itself(const Inputs& in, Words& words) {
  const Meshes meshes(in);
  words.add(self_intersects(meshes.a)), words.add(find_self_pairs(meshes.a));
  words.add(find_self_pairs(meshes.b, {.kind = SelfPairKind::Neighbour}));
  for (const Eigen::Vector3d& point : in.vertices_b)
    words.add(contains(meshes.a, point));
  words.add(contains(meshes.a, in.point));
  words.add(intersects({meshes.a}, {meshes.b}, {.hit = Hit::Solid}));
  ask_for_interiors(in, meshes, words);
  for (const Mesh& mesh : {meshes.a, meshes.b}) {
    const MeshHealth health = check(mesh);
    words.add(std::uint64_t{health.fault_count()}), words.add(health.self_intersections);
  }
  const Topology& topology = meshes.a.topology();
  words.add(std::uint64_t{topology.degenerate_triangles});
  words.add(std::uint64_t{topology.welded_vertices}), words.add(meshes.a.bounds());
}

void ask_for_fits(const Inputs& in, Words& words) {
  const Meshes meshes(in);
  words.add(bounding_sphere(meshes.a)), words.add(bounding_obb(meshes.a));
  words.add(bounding_kdop(meshes.a)), words.add(signed_volume(meshes.a));
  const MeshFit fit = measure_fit(meshes.a);
  for (const VolumeFit& each : fit.volumes) {
    words.add(each.volume), words.add(each.surface);
    words.add(each.empty_share.value_or(-1)), words.add(each.relative_volume.value_or(-1));
  }
}

void ask_bent(const Inputs& in, Words& words) {
  const Meshes meshes(in);
  words.add(intersects({meshes.a, in.pose_a}, {meshes.b, in.pose_b}));
  tree_of(meshes.b);
  const Mesh bent = meshes.b.deformed(in.bent);
  words.add(bent.bounds());
  words.add(find_triangle_pairs({meshes.a, in.pose_a}, {bent, in.pose_b}));
  words.add(
      find_triangle_pairs({meshes.a, in.pose_a}, {bent, in.pose_b}, {.volume = PairVolume::Aabb}));
}

void add_contact(Words& words, const std::optional<MeshFirstContact>& found) {
  words.add(found.has_value());
  if (!found) return;
  words.add(found->time), words.add(found->is_at_start);
  words.add(std::uint64_t{found->pair.a} << 32 | found->pair.b);
}

void ask_paths(const Inputs& in, Words& words) {
  const Meshes meshes(in);
  const MeshPath path(meshes.b, meshes.b.deformed(in.bent)), rest(meshes.a, meshes.a);
  for (const StartContact start : {StartContact::Counts, StartContact::IsLeft}) {
    add_contact(words, first_contact(path, rest, {.start = start}));
    add_contact(words, first_self_contact(path, {.start = start}));
    for (const MeshFirstContact& each : find_contacts_in_step(path, rest, {.start = start}))
      add_contact(words, each);
    for (const MeshFirstContact& each : find_self_contacts_in_step(path, {.start = start}))
      add_contact(words, each);
    const auto met = cast({meshes.a, in.pose_a}, {meshes.b, in.pose_b},
                          Eigen::Vector3d(0.3, -0.2, 0.7), {.start = start});
    words.add(met.has_value());
    if (met) words.add(met->time), words.add(met->point), words.add(met->normal);
    const auto rolled = cast({meshes.a, in.pose_a}, Sphere{in.pose_b.translation(), 0.25},
                             Eigen::Vector3d(0.3, -0.2, 0.7), {.start = start});
    words.add(rolled.has_value());
    if (rolled) words.add(rolled->time), words.add(rolled->point), words.add(rolled->normal);
  }
}

void add_contact(Words& words, const RigidContact& found) {
  words.add(std::uint64_t{static_cast<unsigned>(found.status)});
  words.add(found.low), words.add(found.high);
}

void ask_rigid_motions(const Inputs& in, Words& words) {
  const Meshes meshes(in);
  const RigidMotion rest(in.pose_a);
  const RigidMotion motions[] = {
      RigidMotion::between(in.pose_b, in.pose_a), RigidMotion::screw_between(in.pose_b, in.pose_a),
      RigidMotion::screw(in.pose_b, {.axis = {1, 2, 3}, .angle = 0.7, .pitch = 0.1}),
      RigidMotion::from_velocities(in.pose_b, {.linear = {0.1, 0, 0}, .angular = {0, 0.3, 0.1}})};
  const RigidContactSettings settings{.budget = 10000};
  for (const RigidMotion& motion : motions) {
    for (int i = 0; i < 3; ++i)
      words.add(Eigen::Vector3d(motion.at(0.7).matrix().col(i + 1).head<3>()));
    add_contact(words, first_contact({meshes.a, rest}, {meshes.b, motion}, settings));
    const auto last = last_free({meshes.a, rest}, {meshes.b, motion}, settings);
    words.add(last.value_or(-1));
    const auto proof = certify_free({meshes.a, rest}, {meshes.b, motion}, settings);
    words.add(proof.has_value());
    if (proof) words.add(proves_freedom(*proof, {meshes.a, rest}, {meshes.b, motion}));
    add_contact(words, first_contact({Shape(Sphere{{0, 0, 0}, 0.1}), rest},
                                     {Shape(meshes.b), motion}, settings));
  }
  for (const bool is : is_free({meshes.a, rest}, {meshes.b, motions}, settings))
    words.add(is);
}

void ask_rays(const Inputs& in, Words& words) {
  const Meshes meshes(in);
  if (const auto hit = cast_ray({meshes.a, in.pose_a}, in.ray)) add_hit(words, *hit);
  for (const RayHit& hit : cast_ray_all({meshes.a}, in.ray))
    add_hit(words, hit);
}

void ask_about_points(const Inputs& in, Words& words, int threads) {
  const Meshes meshes(in);
  const PlacedMesh a{meshes.a, in.pose_a};
  const NearestPoint nearest = nearest_point(a, in.point);
  words.add(nearest.distance), words.add(nearest.point), words.add(std::uint64_t{nearest.triangle});
  words.add(signed_distance(a, in.point));
  const BatchSettings batch{.threads = threads};
  for (const NearestPoint& each : nearest_points(a, in.vertices_b, batch))
    words.add(each.distance), words.add(each.point);
  for (const double each : signed_distances(a, meshes.b.vertex_matrix(), batch))
    words.add(each);
  for (const bool is : contains_points(a, in.vertices_b, batch))
    words.add(is);
}

void ask_batches(const Inputs& in, Words& words, int threads) {
  const Meshes meshes(in);
  const PlacedMesh a{meshes.a, in.pose_a};
  const MeshInPoses b{meshes.b, in.poses};
  const BatchSettings batch{.threads = threads};
  for (const bool is : intersects(a, b, {}, batch))
    words.add(is);
  for (const TrianglePairs& pairs : find_triangle_pairs(a, b, {}, batch))
    words.add(pairs);
  if (in.poses.size() > 64) return;  // the rest costs more
  for (const MeshDistance& found : distance(a, b, {}, batch))
    add_distance(words, found);
  for (const bool is : within(a, b, 0.01, {}, batch))
    words.add(is);
  for (const auto& hit : cast_rays(a, std::vector<Ray>(3, in.ray), batch))
    if (hit) add_hit(words, *hit);
}

void ask_voxels(const Inputs& in, Words& words, int threads) {
  const Meshes meshes(in);
  for (const VoxelFill fill : {VoxelFill::Surface, VoxelFill::Solid}) {
    const Voxels voxels =
        find_voxels(meshes.a, {.resolution = 9, .fill = fill, .threads = threads});
    words.add(voxels.grid.origin), words.add(voxels.grid.edge);
    for (const Voxel& voxel : voxels)
      words.add(std::uint64_t{voxel.i} << 32 | std::uint64_t{voxel.j} << 16 | voxel.k);
    if (!voxels.empty()) words.add(voxels.grid.box(voxels.voxels[0]));
  }
}

Question pairs_by_threads(int threads) {
  return {"pairs by many threads", [threads](const Inputs& in, Words& words) {
            const Meshes meshes(in);
            prepare(meshes.a);
            words.add(find_triangle_pairs({meshes.a, in.pose_a}, {meshes.b, in.pose_b},
                                          {.threads = threads}));
          }};
}

Question batches(int threads) {
  return {"batches of poses",
          [threads](const Inputs& in, Words& words) { ask_batches(in, words, threads); }};
}

Question points(int threads) {
  return {"points",
          [threads](const Inputs& in, Words& words) { ask_about_points(in, words, threads); }};
}

Question voxels(int threads) {
  return {"voxels", [threads](const Inputs& in, Words& words) { ask_voxels(in, words, threads); }};
}

template <typename Item>
void add_bits(Words& words, std::span<const Item> items) {
  for (const std::byte byte : std::as_bytes(items))
    words.add(std::to_integer<std::uint64_t>(byte));
}

void ask_trees(const Inputs& in, Words& words) {
  const Meshes meshes(in);
  add_bits(words, std::span<const bvh::Node>(tree_of(meshes.a).nodes));
  add_bits(words, sphere_skin_of(meshes.a)), add_bits(words, obb_skin_of(meshes.a));
  add_bits(words, kdop_skin_of(meshes.a));
  prepare(meshes.b), tree_of(meshes.b);
  const Mesh bent = meshes.b.deformed(in.bent);
  add_bits(words, std::span<const bvh::Node>(tree_of(bent).nodes));
  prepare(bent);
  words.add(find_triangles({bent}, Obb{in.poses[0], {0, 0, 0}}));
  const Eigen::Vector3d corner = bent.bounds().min;
  words.add(within({bent},
                   {Mesh(std::vector<Eigen::Vector3d>{corner, corner, corner},
                         std::vector<TriangleIndices>{{0, 1, 2}})},
                   0));
}

}  // namespace

std::vector<Question> parallel_questions(int threads) {
  return {pairs_by_threads(threads), batches(threads), points(threads), voxels(threads),
          world_questions(threads).back()};
}

Question tree_question() {
  return {"trees", ask_trees};
}

std::vector<Question> mesh_questions(int threads) {
  return {
      {"pairs by each volume", ask_by_volumes},
      {"place",
       [](const Inputs& in, Words& words) {
         for (const Eigen::Vector3d& vertex : in.vertices_a)
           words.add(place(in.pose_b, vertex));
         words.add(place(in.pose_b, in.triangle_a).c);
       }},
      pairs_by_threads(threads),
      {"distance",
       [](const Inputs& in, Words& words) {
         const Meshes meshes(in);
         add_distance(words, distance({meshes.a, in.pose_a}, {meshes.b, in.pose_b}));
       }},
      {"within",
       [](const Inputs& in, Words& words) {
         const Meshes meshes(in);
         for (const Pose& pose : in.poses)
           words.add(within({meshes.a, in.pose_a}, {meshes.b, pose}, in.clearance));
       }},
      {"a pair's memory", ask_with_memory},
      {"mesh and volume", ask_about_volumes},
      {"contacts, intersections, separations", ask_about_contact},
      {"a mesh itself", ask_about_itself},
      {"volumes around a mesh", ask_for_fits},
      {"a mesh that bends", ask_bent},
      {"meshes whose vertices move", ask_paths},
      {"meshes that move and turn", ask_rigid_motions},
      {"rays at a mesh", ask_rays},
      batches(threads),
      points(threads),
      voxels(threads),
  };
}

}  // namespace graze::tests
