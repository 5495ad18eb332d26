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
    Shape shape;
    Pose pose;
    BodySettings settings;
  };
  std::vector<Body> bodies;                                        // user data: the name
  std::vector<std::vector<std::pair<std::uint64_t, Pose>>> steps;  // who goes where
};

/// The bodies that a history brings, all from the start, and its moves.
Scene scene_of(Setting setting, std::size_t count) {
  Scene scene;
  const std::vector<Shape> palette = palette_of(setting);
  scene.steps.emplace_back();
  std::map<std::uint32_t, std::uint64_t> name;
  for (const Operation& operation : random_history(setting, 77, count).operations) {
    if (operation.verb == Verb::Add) {
      name[operation.body] = scene.bodies.size();
      scene.bodies.push_back({palette[operation.number], operation.pose, operation.settings});
      scene.bodies.back().settings.user_data = name[operation.body];
    } else if (operation.verb == Verb::Move || operation.verb == Verb::MoveToo) {
      scene.steps.back().push_back({name.at(operation.body), operation.pose});
    } else if (operation.verb == Verb::Update) {
      scene.steps.emplace_back();
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
    scene.bodies.push_back({shape, pose(i), {.user_data = i}});
  }
  for (const std::uint64_t one_in : {1, 3, 50, 1}) {
    scene.steps.emplace_back();
    for (std::uint64_t i = 0; i < scene.bodies.size(); i += one_in)
      scene.steps.back().push_back({i, pose(i)});
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

/// Under the name of the pair, the smaller body first: mirrored where the world says it otherwise.
/// Two of one shape in one place are the same two either way.
std::map<std::uint64_t, std::uint64_t> hashed_contacts(const World& world, const Scene& scene,
                                                       std::span<const BodyContact> contacts) {
  std::map<std::uint64_t, std::uint64_t> hashes;
  for (const auto& [pair, manifold] : contacts) {
    const std::uint64_t a = world.user_data(pair.a), b = world.user_data(pair.b);
    const bool is_alike = scene.bodies[a].shape.kind() == scene.bodies[b].shape.kind() &&
                          world.pose(pair.a).matrix() == world.pose(pair.b).matrix();
    if (is_alike) continue;
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
    hashes[std::min(a, b) << 32 | std::max(a, b)] = hash.value();
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
    ids[which] = world.add({body.shape, body.pose}, body.settings);
  }
  Hash hash, of_contacts;
  for (const auto& step : scene.steps) {
    std::vector<BodyId> moved;
    std::vector<Pose> poses;
    for (const auto& [name, pose] : step) {
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
    for (const auto& [name, contact] : hashed_contacts(world, scene, update.contacts))
      of_contacts.mix(name), of_contacts.mix(contact);
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
     {2611819615404182040u, 13398864039721944801u}},
    {"lattice",
     [] { return scene_of(Setting::Lattice, 500); },
     {7056363116740708371u, 7847077356679262366u}},
    {"sizes",
     [] { return scene_of(Setting::Sizes, 100); },
     {13712954361472403426u, 3884143959756790999u}},
    {"far",
     [] { return scene_of(Setting::Far, 500); },
     {2611819615404182040u, 3882631389392060016u}},
    {"one_point",
     [] { return scene_of(Setting::OnePoint, 100); },
     {7657835112598276934u, 932040102583963565u}},
    {"skewed",
     [] { return scene_of(Setting::Skewed, 500); },
     {12437386417364618355u, 8241061426393930552u}},
    {"teleports",
     [] { return scene_of(Setting::Teleports, 500); },
     {5188659544485798361u, 2712206577584648611u}},
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
