#include "tests/engine/floating_point/questions.h"

namespace graze::tests {
namespace {

std::vector<Shape> all_shapes(const Inputs& in) {
  return {Shape(Sphere{in.body_poses[1].translation(), 0.7}),
          Shape(Box{{0.5, 0.75, 0.25}}),
          Shape(Capsule{0.3, 0.6}),
          Shape(Cylinder{0.4, 0.7}),
          Shape(Cone{0.6, 0.5}),
          Shape(Ellipsoid{in.body_poses[3].translation(), {0.6, 0.3, 0.4}}),
          Shape(ConvexHull(in.hull_points)),
          Shape(HalfSpace{in.body_poses[5].translation(), 0.1}),
          Shape(Mesh(in.vertices_a, in.triangles_a)),
          Shape(Mesh(in.hull_points, in.triangles_b.size() < 16
                                         ? std::vector<TriangleIndices>{{0, 1, 2}, {3, 4, 5}}
                                         : std::vector<TriangleIndices>{{0, 1, 2}, {6, 7, 8}}))};
}

void add_manifold(Words& words, const Manifold& manifold) {
  for (const ShapeContact& contact : manifold) {
    words.add(contact.point), words.add(contact.normal), words.add(contact.depth);
    words.add(contact.feature.a), words.add(contact.feature.b);
  }
}

void add_distance(Words& words, const ShapeDistance& found) {
  words.add(found.distance), words.add(found.lower_bound), words.add(found.point_a);
  words.add(found.point_b), words.add(found.normal);
}

void ask_pairs_of_shapes(const Inputs& in, Words& words) {
  const std::vector<Shape> shapes = all_shapes(in);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Pose& pose_a = in.body_poses[i];
    words.add(bounding_aabb({shapes[i], pose_a}));
    for (std::size_t j = 0; j < shapes.size(); ++j) {
      const Pose& pose_b = in.body_poses[(i + j) % in.body_poses.size()];
      words.add(intersects({shapes[i], pose_a}, {shapes[j], pose_b}));
      if (const auto met = cast({shapes[i], pose_a}, {shapes[j], pose_b}, in.ray.direction))
        words.add(met->time), words.add(met->point), words.add(met->normal);
      if (i == 7 && j == 7) continue;  // two half-spaces have no contacts
      add_distance(words, distance({shapes[i], pose_a}, {shapes[j], pose_b}));
      add_manifold(words, find_contacts({shapes[i], pose_a}, {shapes[j], pose_b}));
      words.add(share(shapes[i])->touches(pose_a, *share(shapes[j]), pose_b));
      words.add(share(shapes[i])->gap(pose_a, *share(shapes[j]), pose_b));
    }
    if (const auto hit = cast_ray({shapes[i], pose_a}, in.ray)) words.add(hit->point);
  }
  const BoxGap gap = gap_between(in.box_a, in.box_b);
  words.add(gap.gap);
}

void add_update(Words& words, const WorldUpdate& update) {
  for (const auto* list : {&update.begun, &update.ended, &update.moved}) {
    words.add(std::uint64_t{list->size()});
    for (const BodyPair& pair : *list)
      words.add(std::uint64_t{pair.a.index} << 32 | pair.b.index);
  }
  for (const BodyContact& contact : update.contacts)
    add_manifold(words, contact.manifold);
}

void ask_about_bodies(const World& world, const Inputs& in, Words& words) {
  const Shape ball(Sphere{in.body_poses[7].translation(), 1});
  for (const BodyId id : world.find_touching({ball, in.body_poses[0]}))
    words.add(std::uint64_t{id.index});
  for (const BodyId id : world.find_in_box(in.box_a))
    words.add(std::uint64_t{id.index});
  for (const BodyDistance& near : world.find_within({ball, in.body_poses[2]}, 0.25))
    add_distance(words, near.distance);
  if (const auto closest = world.find_closest({ball, in.body_poses[4]}))
    add_distance(words, closest->distance);
  if (const auto hit = world.cast_ray(in.ray)) words.add(hit->hit.point);
  for (const BodyRayHit& hit : world.cast_ray_all(in.ray))
    words.add(hit.hit.distance), words.add(hit.hit.normal);
  for (const BodyContact& contact : world.contacts())
    add_manifold(words, contact.manifold);
}

void ask_in_batches(const World& world, const Inputs& in, Words& words, int threads) {
  const BatchSettings batch{.threads = threads};
  const Shape ball(Sphere{in.body_poses[7].translation(), 1});
  const std::vector<Pose> poses = {in.body_poses[0], in.body_poses[2]};
  for (const auto& hit : cast_rays(world, std::vector<Ray>(3, in.ray), {}, batch))
    if (hit) words.add(hit->hit.point);
  for (const auto& ids : find_touching(world, {ball, poses}, {}, batch))
    words.add(std::uint64_t{ids.size()});
  for (const auto& near : find_within(world, {ball, poses}, 0.25, {}, batch))
    for (const BodyDistance& each : near)
      add_distance(words, each.distance);
  for (const auto& closest : find_closest(world, {ball, poses}, {}, batch))
    if (closest) add_distance(words, closest->distance);
  for (const auto& hits : cast_ray_all(world, std::vector<Ray>(3, in.ray), {}, batch))
    for (const BodyRayHit& hit : hits)
      words.add(hit.hit.distance);
  std::vector<RigidMotion> motions;
  for (const Pose& pose : poses)
    motions.emplace_back(pose, RigidCourse{.shift = {1, 2, -1}, .angle = 0.5});
  for (const auto& met : cast(world, {ball, motions}, {}, {}, batch))
    if (met) words.add(met->contact.low), words.add(met->contact.high);
  for (const auto& casts : cast_all(world, {ball, motions}, {}, {}, batch))
    for (const BodyCast& met : casts)
      words.add(met.contact.low);
}

void ask_world(const Inputs& in, Words& words, int threads) {
  World world({.threads = threads});
  std::vector<BodyId> ids;
  const std::vector<Shape> shapes = all_shapes(in);
  for (std::size_t i = 0; i < shapes.size(); ++i)
    ids.push_back(world.add({shapes[i], in.body_poses[i]}));
  add_update(words, world.update());
  ask_about_bodies(world, in, words);
  ask_in_batches(world, in, words, threads);
  const WorldSnapshot snapshot = world.snapshot();
  for (std::size_t i = 0; i < ids.size(); ++i)
    world.move(ids[i], in.body_poses[(i + 5) % in.body_poses.size()]);
  world.set_shape(ids[1], shapes[2]);
  add_update(words, world.update());
  world.move(ids, std::span(in.body_poses).first(ids.size()));
  world.remove(ids[3]);
  add_update(words, world.update());
  world.restore(snapshot);
  world.move(ids[0], in.body_poses[3]);
  add_update(words, world.update());
  ask_about_bodies(world, in, words);
}

/// Half of the shapes in one body.
void ask_compound(const Inputs& in, Words& words, int threads) {
  const std::vector<Shape> shapes = all_shapes(in);
  Compound compound;
  for (std::size_t i = 0; i < 7; i += 2)
    compound.add({shapes[i], in.body_poses[i]});
  compound.replace(0, {shapes[1], in.body_poses[1]});
  const auto shared = share(compound);
  const Pose& pose = in.body_poses[4];
  words.add(shared->bounds(pose)), words.add(shared->bounding_radius());
  words.add(placed_part(pose, in.body_poses[6]));
  World world({.threads = threads, .islands = true});
  std::vector<BodyId> ids{world.add({shared, pose})};
  for (std::size_t i = 1; i < shapes.size(); i += 2) {
    ids.push_back(world.add({shapes[i], in.body_poses[i]}));
    words.add(shared->touches(pose, world.shape(ids.back()), in.body_poses[i]));
    add_manifold(words,
                 shared->contacts_within(pose, world.shape(ids.back()), in.body_poses[i], 0.125));
  }
  add_update(words, world.update());
  ask_about_bodies(world, in, words);
  for (const BodyContact& contact : world.contacts(ids[0]))
    add_manifold(words, contact.manifold);
  if (const auto hit = shared->cast_ray(pose, in.ray)) words.add(hit->point);
  world.move(ids[0], in.body_poses[2]);
  add_update(words, world.update());
  for (const BodyId id : world.island(ids[0]))
    words.add(std::uint64_t{id.index});
}

void add_pairs(Words& words, std::span<const BoxPair> pairs) {
  words.add(std::uint64_t{pairs.size()});
  for (const BoxPair& pair : pairs)
    words.add(std::uint64_t{pair.a} << 32 | pair.b);
}

void ask_broad_phase(const Inputs& in, Words& words, int threads) {
  BroadPhase boxes({.threads = threads});
  std::vector<BoxId> ids;
  for (const Aabb& box : in.boxes)
    ids.push_back(boxes.add(box));
  boxes.update();
  add_pairs(words, boxes.sorted_pairs());
  boxes.move(ids[0], in.boxes_later[0]);
  boxes.update();
  add_pairs(words, boxes.begun()), add_pairs(words, boxes.ended());
  boxes.move(ids, in.boxes_later);
  std::vector<std::uint32_t> found;
  boxes.find_overlapping(in.box_a, found);
  for (const std::uint32_t index : found)
    words.add(std::uint64_t{index});
  boxes.visit_along(in.ray, [&](std::uint32_t index) {
    words.add(std::uint64_t{index});
    return in.ray.max_distance;
  });
  boxes.remove(ids[1]);
  boxes.update();
  add_pairs(words, boxes.sorted_pairs()), add_pairs(words, boxes.begun());
  add_pairs(words, boxes.ended());
  words.add(boxes.box(ids[2]));
}

}  // namespace

std::vector<Question> world_questions(int threads) {
  return {{"pairs of shapes", ask_pairs_of_shapes},
          {"a world", [threads](const Inputs& in, Words& words) { ask_world(in, words, threads); }},
          {"a compound",
           [threads](const Inputs& in, Words& words) { ask_compound(in, words, threads); }},
          {"a broad phase",
           [threads](const Inputs& in, Words& words) { ask_broad_phase(in, words, threads); }}};
}

}  // namespace graze::tests
