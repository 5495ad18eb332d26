// Recordings: what was done and said is what is read, and repeating it says the same.

#include <graze/bvh/error.h>
#include <graze/engine/record/coding/blocks.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/voxel_map.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "tests/engine/histories/contestant.h"
#include "tests/engine/record/recorded_run.h"

namespace graze::tests {
namespace {

using Eigen::Vector3d;

Pose at(double x, double y, double z) {
  Pose pose = Pose::Identity();
  pose.translation() = Vector3d(x, y, z);
  return pose;
}

bool is_about_bodies(Verb verb) {
  return verb != Verb::Update && verb < Verb::AskTouching;
}

/// Whether a part of a history can be done: what it names is there.
bool can_be_done(const Contestant& contestant, const Operation& operation) {
  if (operation.verb == Verb::Add || operation.verb == Verb::FilterPairs ||
      operation.verb == Verb::Save)
    return true;
  if (operation.verb == Verb::Restore) return contestant.saved.has_value();
  const bool is_of_two = operation.verb == Verb::Exclude || operation.verb == Verb::Include;
  return contestant.ids.contains(operation.body) &&
         (!is_of_two ||
          (contestant.ids.contains(operation.number) && operation.number != operation.body));
}

/// Plays a history, each move by itself, and returns what each update said.
std::vector<RecordedAnswers> play_to(Contestant& contestant, const History& history) {
  std::vector<RecordedAnswers> answers;
  const auto update = [&] {
    answers.push_back(answers_of(contestant.world.update(), RecordedContacts::All, true));
  };
  for (const Operation& operation : history.operations) {
    if (operation.verb == Verb::Update) update();
    if (!is_about_bodies(operation.verb) || !can_be_done(contestant, operation)) continue;
    if (operation.verb == Verb::Save) update();  // none is taken while changes wait
    if (operation.verb == Verb::Move || operation.verb == Verb::MoveToo) {
      contestant.move({&operation, 1});
    } else {
      contestant.tell(operation);
    }
  }
  update();
  return answers;
}

class RecordedHistories : public testing::TestWithParam<Setting> {};

TEST_P(RecordedHistories, AreRepeatedToTheLastBitWhateverTheThreads) {
  RecordedRun run;
  Contestant contestant("recorded", GetParam(), {});
  std::vector<RecordedAnswers> answers;
  {
    WorldRecorder recorder(contestant.world, run.sink(), {.contacts = RecordedContacts::All});
    // Of bodies of parts few meet.
    const std::size_t operations = GetParam() == Setting::Parts ? 3000 : 900;
    History history = random_history(GetParam(), 7, operations);
    history.operations.insert(history.operations.begin() + 60,
                              {.verb = Verb::FilterPairs, .number = 2});
    answers = play_to(contestant, history);
    recorder.finish();
    EXPECT_EQ(recorder.updates(), answers.size());
    EXPECT_EQ(recorder.bytes(), run.bytes.size());
  }
  const std::vector<RecordedStep> steps = steps_of(run.bytes);
  ASSERT_EQ(steps.size(), answers.size());
  std::size_t begun = 0, ended = 0, contacts = 0, refused = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_EQ(steps[i].answers, answers[i]) << i;
    EXPECT_EQ(first_difference(i, steps[i].answers, answers[i]), std::nullopt);
    begun += answers[i].begun.size(), ended += answers[i].ended.size();
    contacts += answers[i].contacts.size(), refused += steps[i].refused.size();
  }
  EXPECT_GT(begun, 20u);
  EXPECT_GT(ended, 10u);
  EXPECT_GT(contacts, 20u);
  EXPECT_GT(refused, 0u) << "no filter of a user's own was asked";
  for (const int threads : {1, 2, 4})
    EXPECT_EQ(first_difference_in(run.bytes, {.threads = threads}), "none") << threads;
  EXPECT_EQ(first_difference_in(run.bytes, {.has_work = true}), "none");
  EXPECT_EQ(first_difference_in(run.bytes, {.skips = false}), "none");
}

class RecordedHistoriesSlow : public testing::TestWithParam<Setting> {};

TEST_P(RecordedHistoriesSlow, AreRepeatedToTheLastBit) {
  for (std::uint64_t seed = 100; seed < 150; ++seed) {
    RecordedRun run;
    Contestant contestant("recorded", GetParam(), {});
    WorldRecorder recorder(contestant.world, run.sink(), {.contacts = RecordedContacts::All});
    play_to(contestant, random_history(GetParam(), seed, 900));
    recorder.finish();
    ASSERT_EQ(first_difference_in(run.bytes, {.threads = 2, .has_work = true}), "none") << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(All, RecordedHistoriesSlow, testing::ValuesIn(kSettings),
                         [](const auto& each) { return std::string(name_of(each.param)); });

TEST_P(RecordedHistories, SayTheSameWithoutARecorder) {
  RecordedRun run;
  const History history = random_history(GetParam(), 8, 400);
  Contestant recorded("recorded", GetParam(), {}), alone("alone", GetParam(), {});
  WorldRecorder recorder(recorded.world, run.sink());
  EXPECT_EQ(play_to(recorded, history), play_to(alone, history)) << "work counters included";
}

INSTANTIATE_TEST_SUITE_P(All, RecordedHistories, testing::ValuesIn(kSettings),
                         [](const auto& each) { return std::string(name_of(each.param)); });

TEST(Recording, BeginsInTheMiddleOfARun) {
  RecordedRun run;
  const History history = random_history(Setting::Terrains, 21, 800);
  const auto middle = history.operations.begin() + 400;
  Contestant contestant("recorded", Setting::Terrains, {.number = 3, .islands = true});
  play_to(contestant, {history.setting, {history.operations.begin(), middle}});
  WorldRecorder recorder(contestant.world, run.sink(), {.contacts = RecordedContacts::All});
  const auto touching = contestant.world.pairs();
  play_to(contestant, {history.setting, {middle, history.operations.end()}});
  recorder.finish();
  const RecordingReader reader = run.reader();
  EXPECT_EQ(reader.start().touching, touching);
  EXPECT_FALSE(reader.start().is_fresh);
  EXPECT_EQ(reader.head().world.number, 3u);
  EXPECT_TRUE(reader.head().world.islands);
  EXPECT_EQ(first_difference_in(run.bytes, {.threads = 2, .has_work = true}), "none");
}

/// Balls in a lattice, some with a margin, and benches of two parts that lie across them; in each
/// update a share of all is moved.
struct Shaken {
  Shaken() : world({.contacts = true}) {
    Compound bench;
    bench.add({Sphere{{0, 0, 0}, 0.5}, at(0, 0, 0)});
    bench.add({Sphere{{0, 0, 0}, 0.5}, at(0.3, 0, 0)});
    const auto parts = share(bench), ball = share(Sphere{{0, 0, 0}, 0.5});
    for (int i = 0; i < 216; ++i) {
      homes.emplace_back(i % 6, i / 6 % 6, i / 36);
      bodies.push_back(world.add({i % 5 == 0 ? parts : ball, at(i % 6, i / 6 % 6, i / 36)},
                                 {.margin = i % 3 == 0 ? 0.01 : 0}));
    }
  }

  void move(double share, std::mt19937_64& random) {
    std::uniform_real_distribution<double> one(0, 1), off(-0.02, 0.02);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (one(random) >= share) continue;
      const Vector3d place = homes[i] + Vector3d{off(random), off(random), off(random)};
      world.move(bodies[i], at(place.x(), place.y(), place.z()));
    }
  }

  World world;
  std::vector<Vector3d> homes;
  std::vector<BodyId> bodies;
};

TEST(Recording, KeepsTheContactsOfPairsThatBegin) {
  Shaken shaken;
  std::mt19937_64 random(5);
  std::size_t kept = 0, others = 0, of_parts = 0;
  for (int step = 0; step < 60; ++step) {
    shaken.move(step % 3 == 0 ? 1 : (step % 3 == 1 ? 0.3 : 0.02), random);
    const WorldUpdate& update = shaken.world.update();
    std::set<BodyPair> named(update.begun.begin(), update.begun.end());
    named.insert(update.begun_near.begin(), update.begun_near.end());
    std::vector<BodyContact> expected;
    for (const BodyContact& contact : update.contacts)
      if (named.contains(contact.pair)) expected.push_back(contact);
    EXPECT_EQ(answers_of(update, RecordedContacts::Begun, false).contacts, expected) << step;
    kept += expected.size(), others += update.contacts.size() - expected.size();
    for (std::size_t i = 1; i < expected.size(); ++i)
      of_parts += expected[i].pair == expected[i - 1].pair ? 1 : 0;
  }
  EXPECT_GT(kept, 1000U);
  EXPECT_GT(others, 1000U);
  EXPECT_GT(of_parts, 10U);
}

/// A ball that goes to and fro through a plate, swept; parts, voxels, and shapes that change.
std::vector<RecordedAnswers> play_everything(World& world) {
  Compound table;
  table.add({Box{{1, 1, 0.1}}, at(0, 0, 1)});
  const std::uint32_t gone = table.add({Box{{0.1, 0.1, 0.5}}, at(0, 0, 0)});
  table.add({Cylinder{0.1, 0.5}, at(0.8, 0.8, 0.5)}, {.user_data = 9, .material = 4});
  table.remove(gone);
  VoxelMap map(VoxelGrid{{0, 0, 0}, 0.25, {40, 40, 20}});
  map.add_block({0, 0, 0}, {39, 39, 1});
  map.remove_block({0, 0, 0}, {15, 15, 1});
  const Vector3d corners[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, 0.2}};
  world.add({HalfSpace{{1, 2, 30}, -5}}, {.kind = BodyKind::Static});
  world.add({Plane{{0.3, 0.1, 1}, -4}}, {.kind = BodyKind::Static});
  world.add({share(table), at(3, 3, 0)}, {.margin = 0.05});
  const BodyId ground = world.add({share(map), at(-2, -2, -0.5)}, {.kind = BodyKind::Static});
  const BodyId hull = world.add({ConvexHull(corners), at(3, 3, 1.05)});
  const BodyId fast =
      world.add({Sphere{{0, 0, 0}, 0.2}, at(2, 2, 3)}, {.detection = Detection::Continuous});
  std::vector<RecordedAnswers> answers;
  BodyId guest{};
  for (int i = 0; i < 60; ++i) {
    world.move(fast, at(2, 2, i % 2 == 0 ? 3 : -3));
    if (i % 10 == 3) {
      const RigidCourse course{.centre = {2, 2, -3}, .shift = {0.5, 0, 5}, .angle = 2};
      world.move(fast, RigidMotion(at(2, 2, i % 2 == 0 ? -3 : 3), course));
    }
    if (i % 7 == 2) guest = world.add({Box{{0.4, 0.4, 0.4}}, at(0.1 * i, 3, 0.2)});
    if (i % 7 == 5) world.remove(guest);
    if (i == 20) map.remove_block({16, 16, 0}, {20, 39, 1});
    if (i == 20) world.set_shape(ground, share(map));
    if (i == 30) world.set_margin(hull, 0.2);
    if (i == 35) world.set_user_data(hull, 77);
    world.move(hull, at(3, 3, 1.05 + 0.05 * std::sin(0.3 * i)));
    answers.push_back(answers_of(world.update(), RecordedContacts::All, true));
    // The next way begins where this one ended.
    if (i % 10 == 3) world.set_detection(fast, Detection::Continuous);
  }
  return answers;
}

TEST(Recording, KeepsShapesOfAllKindsAndWays) {
  RecordedRun run;
  World world;
  WorldRecorder recorder(world, run.sink(), {.contacts = RecordedContacts::All});
  const std::vector<RecordedAnswers> answers = play_everything(world);
  recorder.finish();
  std::size_t met = 0, near = 0;
  for (const RecordedAnswers& each : answers)
    met += each.first_contacts.size(), near += each.begun_near.size();
  EXPECT_GT(met, 10u) << "the swept ball met nothing";
  EXPECT_GT(near, 0u);
  const std::vector<RecordedStep> steps = steps_of(run.bytes);
  ASSERT_EQ(steps.size(), answers.size());
  for (std::size_t i = 0; i < steps.size(); ++i)
    EXPECT_EQ(steps[i].answers, answers[i]) << i;
  EXPECT_EQ(first_difference_in(run.bytes, {.threads = 3, .has_work = true}), "none");
}

TEST(Recording, KeepsWhatIsNoBodysShapeByItself) {
  RecordedRun run;
  World world;
  WorldRecorder recorder(world, run.sink(), {.seconds_per_update = 0.25, .note = "two balls"});
  const BodyId a = world.add({Sphere{{0, 0, 0}, 1}, at(0, 0, 0)});
  const BodyId b = world.add({Sphere{{0, 0, 0}, 1}, at(1, 0, 0)});
  recorder.name(b, "the second");
  EXPECT_THROW(recorder.name({7, 1}, "nobody"), StaleIdError);
  world.update();
  world.remove(a);
  EXPECT_THROW(recorder.name(a, "gone"), StaleIdError);
  world.update();
  recorder.finish();
  const RecordingReader reader = run.reader();
  EXPECT_EQ(reader.head().note, "two balls");
  EXPECT_EQ(reader.head().seconds_per_update, 0.25);
  const std::vector<RecordedStep> steps = steps_of(run.bytes);
  ASSERT_EQ(steps.size(), 2u);
  ASSERT_EQ(steps[0].changes.size(), 3u);
  EXPECT_EQ(std::get<BodyAdded>(steps[0].changes[0]).shape, 0u);
  EXPECT_EQ(std::get<BodyAdded>(steps[0].changes[1]).shape, 0u) << "equal shapes are one";
  EXPECT_EQ(std::get<BodyNamed>(steps[0].changes[2]).name, "the second");
  EXPECT_EQ(std::get<BodyRemoved>(steps[1].changes[0]).id, a);
  EXPECT_EQ(steps[0].answers.begun, (std::vector<BodyPair>{{a, b}}));
  EXPECT_EQ(steps[0].answers.contacts.size(), 1u) << "of what begins";
  EXPECT_EQ(steps[1].answers.ended, (std::vector<BodyPair>{{a, b}}));
}

/// Bodies that came before the recorder did, and have not been updated.
TEST(Recording, BeginsBeforeTheFirstUpdate) {
  RecordedRun run;
  World world;
  const BodyId a = world.add({Box{{1, 1, 1}}, at(0, 0, 0)});
  const BodyId b = world.add({Box{{1, 1, 1}}, at(1, 0, 0)});
  const BodyId c = world.add({Box{{1, 1, 1}}, at(0, 1, 0)});
  world.exclude(a, b);
  WorldRecorder recorder(world, run.sink());
  world.update();
  world.include(a, b);
  world.update();
  recorder.finish();
  const std::vector<RecordedStep> steps = steps_of(run.bytes);
  EXPECT_EQ(steps[0].answers.begun, (std::vector<BodyPair>{{a, c}, {b, c}}));
  EXPECT_EQ(steps[1].answers.begun, (std::vector<BodyPair>{{a, b}}));
  EXPECT_EQ(first_difference_in(run.bytes, {.has_work = true}), "none");
}

/// Three balls of which the second comes to the first in update 5.
std::string approach() {
  RecordedRun run;
  World world;
  WorldRecorder recorder(world, run.sink(),
                         {.contacts = RecordedContacts::None, .has_work = false});
  world.add({Sphere{{0, 0, 0}, 1}, at(0, 0, 0)});
  const BodyId b = world.add({Sphere{{0, 0, 0}, 1}, at(7, 0, 0)});
  world.add({Sphere{{0, 0, 0}, 1}, at(0, 50, 0)});
  for (int i = 0; i < 10; ++i) {
    if (i > 0) world.move(b, at(7 - i, 0, 0));
    world.update();
  }
  recorder.finish();
  return run.bytes;
}

/// The recording with another partner in the pair that begins in update 5: 2 in the place of 1.
std::string with_a_lie(const std::string& bytes) {
  std::string changed = bytes.substr(0, record::kMagic.size() + 4);
  std::size_t update = 0, found = 0;
  for (std::size_t at = changed.size(); at < bytes.size();) {
    const auto kind = static_cast<record::BlockKind>(bytes[at]);
    std::size_t length = 0;
    for (std::size_t k = 0; k < 4; ++k)
      length |= std::size_t{static_cast<unsigned char>(bytes[at + 1 + k])} << 8 * k;
    std::string content = bytes.substr(at + record::kFrontBytes, length);
    at += record::kFrontBytes + length + record::kBackBytes;
    if (kind == record::BlockKind::Step && update++ == 5) {
      // The end of changes, no failure, none refused; one pair: 0, and 1 behind it.
      const std::size_t place = content.find(std::string("\0\0\0\1\0\2", 6));
      if (place != std::string::npos) content[place + 5] = 4, ++found;
    }
    record::append_block(kind, content, changed);
  }
  EXPECT_EQ(found, 1u);
  return changed;
}

TEST(Recording, NamesTheUpdateAndThePairThatDiffer) {
  const std::string bytes = approach();
  EXPECT_EQ(first_difference_in(bytes), "none");
  EXPECT_EQ(first_difference_in(with_a_lie(bytes)),
            "update 5: begun of 0 and 1: not listed / listed");
  RecordingReplay replay(reader_of(with_a_lie(bytes)));
  std::size_t differing = 0;
  while (replay.advance())
    differing += replay.difference() ? 1 : 0;
  EXPECT_EQ(differing, 1u) << "inputs do not follow from answers";
  EXPECT_EQ(replay.reader().end(), RecordingEnd::Complete);
}

TEST(Recording, WhatWasDoneIsComparedToTheBit) {
  const std::vector<RecordedChange> first{BodyMoved{{1, 1}, at(1, 0, 0)}};
  const std::vector<RecordedChange> second{BodyMoved{{1, 1}, at(std::nextafter(1.0, 2.0), 0, 0)}};
  EXPECT_EQ(first_difference(3, first, first), std::nullopt);
  const auto found = first_difference(3, first, second);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->what, "change 0");
  EXPECT_EQ(found->second, "moved: body 1, but otherwise");
  EXPECT_EQ(first_difference(3, first, {})->second, "none");
}

/// Free flight: three numbers of a pose are guessed to the last bits, the others exactly.
TEST(Recording, StaysSmall) {
  RecordedRun run;
  World world;
  WorldRecorder recorder(world, run.sink());
  constexpr int kBodies = 100, kUpdates = 200;
  std::vector<BodyId> ids;
  for (int i = 0; i < kBodies; ++i)
    ids.push_back(world.add({Sphere{{0, 0, 0}, 0.1}, at(i, 0, 0)}));
  world.update();
  const std::uint64_t before = recorder.bytes();
  for (int k = 1; k <= kUpdates; ++k) {
    const double t = k / 60.0;
    for (int i = 0; i < kBodies; ++i) {
      Pose pose(Eigen::AngleAxisd(3 * t, Vector3d(1, 2, 2) / 3));
      pose.translation() = Vector3d(i, 0.3 * t, 2 * t - 4.9 * t * t);
      world.move(ids[static_cast<std::size_t>(i)], pose);
    }
    world.update();
  }
  const double each = static_cast<double>(recorder.bytes() - before) / (kBodies * kUpdates);
  EXPECT_LT(each, 24) << "bytes for a body and an update, of 96 that a pose has";
  EXPECT_EQ(first_difference_in(run.bytes), "none");
}

}  // namespace
}  // namespace graze::tests
