// Law 8 of whole worlds: what a world says, by its bodies' own names, is the same for any number of
// threads, on any SIMD target, and whatever the order in which its bodies came.

#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <map>
#include <string>
#include <vector>

#include "tests/engine/broad_phase/box_histories.h"
#include "tests/engine/histories/history.h"
#include "tests/engine/histories/oracle.h"
#include "tests/engine/histories/whole.h"
#include "tests/narrowphase/simd_targets.h"

namespace graze::tests {
namespace {

/// FNV-1a over the bytes of numbers.
class Hash {
 public:
  void mix(std::uint64_t number) {
    for (int byte = 0; byte < 8; ++byte) {
      hash_ ^= number >> (8 * byte) & 0xff;
      hash_ *= 0x100000001b3u;
    }
  }
  void mix(double number) { mix(std::bit_cast<std::uint64_t>(number + 0.0)); }  // one zero
  void mix(const Eigen::Vector3d& v) { mix(v.x()), mix(v.y()), mix(v.z()); }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

/// The same bodies and moves for all.
struct Scene {
  struct Body {
    std::shared_ptr<const BodyShape> shape;
    Pose pose;
    BodySettings settings;
  };
  struct Step {
    std::vector<std::pair<std::uint64_t, Pose>> moves;  // who goes where
    std::vector<std::pair<std::uint64_t, std::shared_ptr<const BodyShape>>> changes;
  };
  std::vector<Body> bodies;  // user data: the name
  std::vector<Step> steps;
};

/// The bodies that a history brings, all from the start, its moves, and what it does to parts.
Scene scene_of(Setting setting, std::size_t count) {
  Scene scene;
  const std::vector<Shape> palette = palette_of(setting);
  const std::vector<PartsPlan> plans = plans_of(setting);
  Oracle oracle(setting);  // knows what is passed over
  std::map<std::uint64_t, Whole> wholes;
  const auto shape_of = [&](std::uint64_t name, std::uint32_t number) {
    if (number < palette.size()) return share(palette[number]);
    const auto [at, is_new] =
        wholes.emplace(name, whole_of(plans[number - palette.size()], palette));
    return shared(at->second);
  };
  scene.steps.emplace_back();
  std::map<std::uint32_t, std::uint64_t> name;
  for (const Operation& operation : random_history(setting, 77, count).operations) {
    if (operation.verb == Verb::Add) {
      oracle.change(operation);
      name[operation.body] = scene.bodies.size();
      scene.bodies.push_back(
          {shape_of(scene.bodies.size(), operation.number), operation.pose, operation.settings});
      scene.bodies.back().settings.user_data = name[operation.body];
    } else if (operation.verb == Verb::Move || operation.verb == Verb::MoveToo) {
      scene.steps.back().moves.push_back({name.at(operation.body), operation.pose});
    } else if (operation.verb == Verb::Update) {
      scene.steps.emplace_back();
    } else if (is_about_a_part(operation.verb) && !oracle.concerns_nobody(operation)) {
      oracle.change(operation);
      Whole& whole = wholes.at(name.at(operation.body));
      change(whole, operation, palette);
      scene.steps.back().changes.push_back({name.at(operation.body), shared(whole)});
    }
  }
  return scene;
}

/// So many that threads share the work: balls and boxes in three layers, all of which move.
Scene crowd_scene() {
  Scene scene;
  test::Chance chance(9);
  constexpr std::uint64_t kSide = 60;
  const auto pose = [&](std::uint64_t i) {
    Pose at = Pose::Identity();
    const double x = static_cast<double>(i % kSide), y = static_cast<double>(i / kSide % kSide);
    at.translation() = Eigen::Vector3d{x, y, static_cast<double>(i / kSide / kSide)};
    at.translation().x() += chance.between(-0.2, 0.2);
    at.translation().y() += chance.between(-0.2, 0.2);
    return at;
  };
  for (std::uint64_t i = 0; i < 3 * kSide * kSide; ++i) {
    const Shape shape = i % 3 == 0 ? Shape(Box{{0.4, 0.4, 0.5}}) : Shape(Sphere{{0, 0, 0}, 0.45});
    scene.bodies.push_back({share(shape), pose(i), {.user_data = i}});
  }
  for (const std::uint64_t one_in : {1, 3, 50, 1}) {
    scene.steps.emplace_back();
    for (std::uint64_t i = 0; i < scene.bodies.size(); i += one_in)
      scene.steps.back().moves.push_back({i, pose(i)});
  }
  return scene;
}

struct Order {
  std::size_t first = 0;  // the body that comes first; the others follow in a circle
  bool is_backwards = false;
};

std::vector<std::uint64_t> sorted_names(const World& world, std::span<const BodyPair> pairs) {
  std::vector<std::uint64_t> names;
  for (const BodyPair& pair : pairs) {
    const std::uint64_t a = world.user_data(pair.a), b = world.user_data(pair.b);
    names.push_back(std::min(a, b) << 32 | std::max(a, b));
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// What of a body is in a contact: which kind of shape, and where.
std::pair<ShapeKind, Pose> part_in(const World& world, BodyId id, std::uint32_t part) {
  const BodyShape& shape = world.shape(id);
  const Pose& pose = world.pose(id);
  if (const Compound* compound = compound_of(shape)) {
    const PlacedShape& placed = compound->part(part);
    return {placed.shape.kind(), placed_part(pose, placed.pose)};
  }
  if (const VoxelMap* map = voxel_map_of(shape))
    return {ShapeKind::Box, placed_part(pose, map->pose(part))};
  return {shape.shape()->kind(), pose};
}

/// A pair of bodies and one of their parts, the smaller body's first.
using PartPair = std::pair<std::uint64_t, std::uint64_t>;

/// Under the name of the pair, mirrored where the world says it otherwise. Two of one shape in one
/// place are the same two either way.
std::map<PartPair, std::uint64_t> hashed_contacts(const World& world,
                                                  std::span<const BodyContact> contacts) {
  const auto packed = [](std::uint64_t s, std::uint64_t t) { return s << 32 | t; };
  std::map<PartPair, std::uint64_t> hashes;
  for (const auto& [pair, manifold] : contacts) {
    const std::uint64_t a = world.user_data(pair.a), b = world.user_data(pair.b);
    const std::uint32_t part_a = manifold.part_a(), part_b = manifold.part_b();
    const auto [kind_a, pose_a] = part_in(world, pair.a, part_a);
    const auto [kind_b, pose_b] = part_in(world, pair.b, part_b);
    if (kind_a == kind_b && pose_a.matrix() == pose_b.matrix()) continue;
    Hash hash;
    for (const ShapeContact& contact : manifold) {
      hash.mix(contact.point);
      hash.mix(a < b ? contact.point_a : contact.point_b);
      hash.mix(a < b ? contact.point_b : contact.point_a);
      hash.mix(a < b ? contact.normal : Eigen::Vector3d(-contact.normal));
      hash.mix(contact.depth);
      hash.mix(a < b ? contact.feature.a : contact.feature.b);
      hash.mix(a < b ? contact.feature.b : contact.feature.a);
    }
    const PartPair key = a < b ? PartPair{packed(a, b), packed(part_a, part_b)}
                               : PartPair{packed(b, a), packed(part_b, part_a)};
    hashes[key] = hash.value();
  }
  return hashes;
}

/// What touches, begins, ends and moves; and where.
struct Hashes {
  std::uint64_t pairs;
  std::uint64_t contacts;
};

Hashes run(const Scene& scene, const WorldSettings& settings, const Order& order = {}) {
  World world(settings);
  const std::size_t count = scene.bodies.size();
  std::vector<BodyId> ids(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t turn = (order.first + i) % count;
    const std::size_t which = order.is_backwards ? count - 1 - turn : turn;
    const Scene::Body& body = scene.bodies[which];
    ids[which] = world.add(PlacedBodyShape{body.shape, body.pose}, body.settings);
  }
  Hash hash, of_contacts;
  for (const auto& step : scene.steps) {
    std::vector<BodyId> moved;
    std::vector<Pose> poses;
    for (const auto& [name, shape] : step.changes)
      world.set_shape(ids[name], shape);
    for (const auto& [name, pose] : step.moves) {
      moved.push_back(ids[name]);
      poses.push_back(pose);
    }
    world.move(moved, poses);
    const WorldUpdate update = world.update();
    for (const std::span<const BodyPair> list : {update.begun, update.ended, update.moved}) {
      hash.mix(static_cast<std::uint64_t>(list.size()));
      for (const std::uint64_t name : sorted_names(world, list))
        hash.mix(name);
    }
    for (const auto& [parts, contact] : hashed_contacts(world, update.contacts)) {
      of_contacts.mix(parts.first);
      if (parts.second != 0) of_contacts.mix(parts.second);
      of_contacts.mix(contact);
    }
  }
  for (const std::uint64_t name : sorted_names(world, world.pairs()))
    hash.mix(name);
  return {hash.value(), of_contacts.value()};
}

struct Golden {
  const char* name;
  Scene (*scene)();
  Hashes hashes;
};

const Golden kGolden[] = {
    {"crowd",
     [] { return scene_of(Setting::Crowd, 500); },
     {2611819615404182040u, 12586653686866440317u}},
    {"lattice",
     [] { return scene_of(Setting::Lattice, 500); },
     {7056363116740708371u, 4818339054784174213u}},
    {"sizes",
     [] { return scene_of(Setting::Sizes, 100); },
     {13712954361472403426u, 6036313226694605142u}},
    {"far",
     [] { return scene_of(Setting::Far, 500); },
     {2611819615404182040u, 8595650407701859693u}},
    {"one_point",
     [] { return scene_of(Setting::OnePoint, 100); },
     {7657835112598276934u, 8309636803847376605u}},
    {"skewed",
     [] { return scene_of(Setting::Skewed, 500); },
     {12437386417364618355u, 13589433872092866006u}},
    {"teleports",
     [] { return scene_of(Setting::Teleports, 500); },
     {5188659544485798361u, 11483856415909230242u}},
    {"parts",
     [] { return scene_of(Setting::Parts, 500); },
     {7506641623516977435u, 14898967600783930833u}},
    {"thousands", crowd_scene, {4889208235947139791u, 5804464388043734513u}},
};

void expect_golden(const Hashes& found, const Golden& golden, const std::string& of) {
  EXPECT_EQ(found.pairs, golden.hashes.pairs) << of;
  EXPECT_EQ(found.contacts, golden.hashes.contacts) << of;
}

class WorldDeterminism : public testing::TestWithParam<Golden> {};

TEST_P(WorldDeterminism, Threads) {
  const Scene scene = GetParam().scene();
  for (const int threads : {1, 2, 4, 8})
    expect_golden(run(scene, {.threads = threads}), GetParam(), std::to_string(threads));
}

TEST_P(WorldDeterminism, SimdTargets) {
  const Scene scene = GetParam().scene();
  for (const std::int64_t target : narrowphase::simd_targets()) {
    narrowphase::force_simd_target(target);
    expect_golden(run(scene, {}), GetParam(), hwy::TargetName(target));
    narrowphase::force_simd_target(0);
  }
}

TEST_P(WorldDeterminism, OrderOfInsertionAndSkips) {
  const Scene scene = GetParam().scene();
  for (const Order order : {Order{1, false}, Order{0, true}, Order{scene.bodies.size() / 3, true}})
    expect_golden(run(scene, {}, order), GetParam(), std::to_string(order.first));
  const WorldSettings nothing_skipped{
      .skip_apart = false, .skip_at_rest = false, .skip_unused_trees = false};
  expect_golden(run(scene, nothing_skipped), GetParam(), "nothing skipped");
}

std::string name_of_test(const testing::TestParamInfo<Golden>& golden) {
  return golden.param.name;
}
INSTANTIATE_TEST_SUITE_P(Of, WorldDeterminism, testing::ValuesIn(kGolden), name_of_test);

}  // namespace
}  // namespace graze::tests
