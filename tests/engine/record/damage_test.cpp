// Recordings that are damaged, cut off, or made by somebody else; writers that fail or are killed.

#include <graze/bvh/error.h>
#include <graze/engine/record/coding/blocks.h>
#include <graze/engine/world/compound.h>
#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <thread>

#include "tests/engine/record/recorded_run.h"
#include "tests/files/temporary_directory.h"

namespace graze::tests {
namespace {

using Eigen::Vector3d;

Pose at(double x, double y, double z) {
  Pose pose = Pose::Identity();
  pose.translation() = Vector3d(x, y, z);
  return pose;
}

/// A few bodies of several kinds, and all that may happen to them.
void play_a_little(World& world, int updates) {
  Compound pair;
  pair.add({Sphere{{0, 0, 0}, 0.5}, at(0, 0, 0)});
  pair.add({Sphere{{0, 0, 0}, 0.5}, at(1, 0, 0)});
  const Vector3d vertices[] = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}};
  const TriangleIndices triangles[] = {{0, 1, 2}};
  const BodyId floor = world.add({Mesh(vertices, triangles)}, {.kind = BodyKind::Static});
  const BodyId a = world.add({share(pair), at(2, 2, 2)});
  BodyId b = world.add({Sphere{{0, 0, 0}, 1}, at(2, 2, 4)}, {.detection = Detection::Continuous});
  world.set_pair_filter([](BodyId s, BodyId t) { return s.index + t.index != 1; });
  for (int i = 0; i < updates; ++i) {
    if (i > 0) world.move(a, at(2, 2, 2 - 0.25 * i));
    if (i == 2) world.exclude(floor, b);
    if (i == 3) world.remove(b);
    if (i == 4) b = world.add({Box{{1, 1, 1}}, at(2, 2, 1)});
    if (i == 5) world.set_pair_filter({});
    world.update();
  }
}

std::string a_recording() {
  RecordedRun run;
  World world;
  WorldRecorder recorder(world, run.sink(), {.contacts = RecordedContacts::All});
  play_a_little(world, 7);
  recorder.finish();
  return run.bytes;
}

enum class Outcome { Refused, CutOff, Whole };

/// Reads all, and checks that what is read is what was written, up to where it ends.
Outcome read(const std::string& bytes, const std::vector<RecordedStep>& whole) {
  try {
    RecordingReader reader = reader_of(bytes);
    std::size_t count = 0;
    while (const RecordedStep* step = reader.next()) {
      EXPECT_LT(count, whole.size());
      EXPECT_EQ(step->answers, whole[count].answers);
      EXPECT_EQ(first_difference(count, step->changes, whole[count].changes), std::nullopt);
      ++count;
    }
    EXPECT_EQ(reader.end() == RecordingEnd::Complete,
              count == whole.size() && bytes.size() > 0 && reader.end() == RecordingEnd::Complete);
    return reader.end() == RecordingEnd::Complete ? Outcome::Whole : Outcome::CutOff;
  } catch (const RecordingError& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, 20), "run.recording: byte ") << error.what();
    EXPECT_TRUE(error.place().byte.has_value());
    return Outcome::Refused;
  }
}

TEST(RecordingDamage, EachByteThatIsOtherwiseIsNoticed) {
  const std::string bytes = a_recording();
  const std::vector<RecordedStep> whole = steps_of(bytes);
  ASSERT_EQ(whole.size(), 7u);
  ASSERT_EQ(read(bytes, whole), Outcome::Whole);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (const int bits : {1, 128, 255}) {
      std::string damaged = bytes;
      damaged[i] = static_cast<char>(damaged[i] ^ bits);
      EXPECT_EQ(read(damaged, whole), Outcome::Refused) << "byte " << i;
    }
  }
}

TEST(RecordingDamage, WhatIsCutOffIsReadAsFarAsItGoes) {
  const std::string bytes = a_recording();
  const std::vector<RecordedStep> whole = steps_of(bytes);
  std::size_t refused = 0, cut_off = 0;
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const Outcome outcome = read(bytes.substr(0, length), whole);
    EXPECT_NE(outcome, Outcome::Whole) << length;
    refused += outcome == Outcome::Refused ? 1 : 0;
    cut_off += outcome == Outcome::CutOff ? 1 : 0;
    // Without a world there is nothing to read; from then on there is no refusal.
    EXPECT_FALSE(outcome == Outcome::Refused && cut_off > 0) << length;
  }
  EXPECT_GT(refused, 0u);
  EXPECT_GT(cut_off, bytes.size() / 2);
  EXPECT_EQ(read(bytes + "x", whole), Outcome::Refused) << "more than there can be";
}

TEST(RecordingDamage, AnUpdateThatIsLeftOutIsMissed) {
  const std::string bytes = a_recording();
  std::string changed = bytes.substr(0, record::kMagic.size() + 4);
  std::size_t updates = 0;
  for (std::size_t at = changed.size(); at < bytes.size();) {
    std::size_t length = record::kFrontBytes + record::kBackBytes;
    for (std::size_t k = 0; k < 4; ++k)
      length += std::size_t{static_cast<unsigned char>(bytes[at + 1 + k])} << 8 * k;
    const bool is_update = bytes[at] == static_cast<char>(record::BlockKind::Step);
    if (!is_update || updates++ != 6) changed += bytes.substr(at, length);
    at += length;
  }
  RecordingReader reader = reader_of(changed);
  for (int i = 0; i < 6; ++i)
    ASSERT_NE(reader.next(), nullptr);
  EXPECT_THROW(reader.next(), RecordingError);
  EXPECT_THROW(reader.next(), RecordingError) << "and again";
}

/// Content that nobody has written, with checksums that fit: whatever it says, there is an error of
/// the library or an answer.
TEST(RecordingDamage, ContentOfOthersIsReadOrRefused) {
  const std::string bytes = a_recording();
  std::mt19937 random(5);
  std::size_t refused = 0, replayed = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string changed = bytes.substr(0, record::kMagic.size() + 4);
    for (std::size_t at = changed.size(); at < bytes.size();) {
      std::size_t length = 0;
      for (std::size_t k = 0; k < 4; ++k)
        length |= std::size_t{static_cast<unsigned char>(bytes[at + 1 + k])} << 8 * k;
      std::string content = bytes.substr(at + record::kFrontBytes, length);
      for (int k = 0; k < 1 && !content.empty() && random() % 4 == 0; ++k)
        content[random() % content.size()] = static_cast<char>(random());
      if (!content.empty() && random() % 40 == 0) content.resize(random() % content.size());
      record::append_block(static_cast<record::BlockKind>(bytes[at]), content, changed);
      at += record::kFrontBytes + length + record::kBackBytes;
    }
    try {
      first_difference_in(changed);
      ++replayed;
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100u);
  EXPECT_GT(replayed, 100u);
}

TEST(RecordingDamage, OtherFilesAreNamed) {
  const TemporaryDirectory folder;
  const auto refusal = [](const std::string& file) {
    try {
      RecordingReader reader{std::filesystem::path(file)};
    } catch (const RecordingError& error) {
      EXPECT_EQ(error.place().file, file);
      return std::string(error.what());
    }
    return std::string("read");
  };
  const std::string none = folder.path("none");
  EXPECT_EQ(refusal(none), none + ": cannot be read");
  EXPECT_EQ(refusal(folder.path("")), folder.path("") + ": is a folder");
  const std::string text = folder.write("text", "no recording");
  EXPECT_EQ(refusal(text), text + ": byte 0: is no recording of a world");
  const std::string later = folder.write("later", std::string("GRAZEREC\2\0\0\0", 12));
  EXPECT_EQ(refusal(later), later + ": byte 8: is of format version 2; this graze reads 1");
  const std::string brief = folder.write("brief", std::string("GRAZEREC\1\0", 10));
  EXPECT_EQ(refusal(brief), brief + ": byte 10: ends before there is a world");
}

/// Touches nothing, and is a class of a user's own.
class UsersShape : public BodyShape {
 public:
  Aabb bounds(const Pose& pose) const override {
    return {pose.translation() - Vector3d(1, 1, 1), pose.translation() + Vector3d(1, 1, 1)};
  }
  bool touches(const Pose&, const BodyShape&, const Pose&) const override { return false; }
};

TEST(WorldRecorder, RefusesWhatItCannotKeep) {
  World world;
  RecordedRun run, other;
  EXPECT_THROW(WorldRecorder(world, run.sink(), {.seconds_per_update = -1}), InputError);
  EXPECT_THROW(WorldRecorder(world, run.sink(),
                             {.seconds_per_update = std::numeric_limits<double>::quiet_NaN()}),
               InputError);
  EXPECT_THROW(WorldRecorder(world, std::function<void(std::string_view)>()), InputError);
  EXPECT_THROW(WorldRecorder(world, std::filesystem::path("/nowhere/at/all")), Error);
  WorldRecorder recorder(world, run.sink());
  EXPECT_THROW(WorldRecorder(world, other.sink()), InputError) << "it is being recorded";
  recorder.finish();
  world.add({std::make_shared<UsersShape>(), at(0, 0, 0)});
  EXPECT_THROW(WorldRecorder(world, other.sink()), InputError) << "a shape of a user's own";
  world.update();
  const BodyId ball = world.add({Sphere{{0, 0, 0}, 1}, at(9, 0, 0)});
  EXPECT_THROW(WorldRecorder(world, other.sink()), InputError) << "changes wait";
  world.remove(ball);
}

TEST(WorldRecorder, AShapeOfAUsersOwnEndsTheRecordingAndNotTheWorld) {
  World world;
  RecordedRun run;
  WorldRecorder recorder(world, run.sink());
  world.add({Sphere{{0, 0, 0}, 1}, at(0, 0, 0)});
  world.update();
  world.add({std::make_shared<UsersShape>(), at(0, 0, 0)});
  EXPECT_TRUE(recorder.has_failed());
  world.add({Sphere{{0, 0, 0}, 1}, at(1, 0, 0)});
  EXPECT_EQ(world.update().begun.size(), 1u);
  EXPECT_THROW(recorder.finish(), InputError);
  EXPECT_NO_THROW(recorder.finish()) << "told once";
  RecordingReader reader = run.reader();
  EXPECT_NE(reader.next(), nullptr);
  EXPECT_EQ(reader.next(), nullptr);
  EXPECT_EQ(reader.end(), RecordingEnd::CutOff);
}

TEST(WorldRecorder, WhatASinkThrowsIsToldAtTheEnd) {
  World world;
  int calls = 0;
  WorldRecorder recorder(world, [&](std::string_view) {
    if (++calls == 3) throw std::runtime_error("the disk is full");
  });
  play_a_little(world, 5);
  EXPECT_TRUE(recorder.has_failed());
  EXPECT_EQ(recorder.updates(), 1u);
  EXPECT_EQ(calls, 3);
  EXPECT_THROW(recorder.finish(), std::runtime_error);
}

TEST(WorldRecorder, OutlivesItsWorldAndTheOtherWayRound) {
  RecordedRun first, second;
  std::optional<WorldRecorder> recorder;
  {
    World world;
    recorder.emplace(world, first.sink());
    world.update();
    World moved = std::move(world);
    moved.update();
  }
  recorder->finish();
  EXPECT_EQ(steps_of(first.bytes).size(), 2u);
  World world;
  recorder.emplace(world, second.sink());
  world.update();
  WorldRecorder taken = std::move(*recorder);
  recorder.reset();
  world.update();
  taken.finish();
  world.update();
  EXPECT_EQ(steps_of(second.bytes).size(), 2u);
}

/// A filter that throws cuts an update short: the next one tells what had begun.
TEST(WorldRecorder, AnUpdateThatWasCutShortIsRepeated) {
  RecordedRun run;
  World world;
  WorldRecorder recorder(world, run.sink());
  world.add({Sphere{{0, 0, 0}, 1}, at(0, 0, 0)});
  world.add({Sphere{{0, 0, 0}, 1}, at(1, 0, 0)});
  bool throws = true;
  world.set_pair_filter([&](BodyId, BodyId) {
    if (throws) throw std::runtime_error("not now");
    return true;
  });
  EXPECT_THROW(world.update(), std::runtime_error);
  throws = false;
  EXPECT_EQ(world.update().begun.size(), 1u);
  recorder.finish();
  const std::vector<RecordedStep> steps = steps_of(run.bytes);
  ASSERT_EQ(steps.size(), 1u);
  EXPECT_TRUE(steps[0].follows_failure);
  EXPECT_EQ(first_difference_in(run.bytes), "none");
}

/// Updates that a program leaves that is killed after six of them; each is repeated to the bit.
std::size_t left_by_killed(RecordedWriting writing) {
  const TemporaryDirectory folder;
  const std::string file = folder.path("killed.recording");
  const pid_t child = fork();
  if (child == 0) {
    World world;
    const WorldRecorder recorder(world, std::filesystem::path(file), {.writing = writing});
    play_a_little(world, 6);
    raise(SIGKILL);
  }
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status));
  RecordingReplay replay(RecordingReader{std::filesystem::path(file)});
  std::size_t updates = 0;
  while (replay.advance()) {
    EXPECT_EQ(replay.difference(), std::nullopt);
    ++updates;
  }
  EXPECT_EQ(replay.reader().end(), RecordingEnd::CutOff);
  return updates;
}

TEST(WorldRecorder, AWriterThatIsKilledLeavesItsUpdates) {
  EXPECT_EQ(left_by_killed(RecordedWriting::AtOnce), 6u) << "all";
  EXPECT_GE(left_by_killed(RecordedWriting::Behind), 2u) << "all but four";
}

TEST(WorldRecorder, AtOnceIsBeforeAnUpdateReturnsAndBehindTheSameBytesCome) {
  RecordedRun at_once, behind;
  World first, second;
  WorldRecorder recorder(first, at_once.sink(), {.writing = RecordedWriting::AtOnce});
  std::size_t before = at_once.bytes.size();
  // A sink that is slower than the world, which waits for it then and loses nothing.
  std::atomic<int> inside = 0, most = 0;
  WorldRecorder slow(second, [&](std::string_view bytes) {
    most = std::max(most.load(), ++inside);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    behind.bytes += bytes;
    --inside;
  });
  for (int i = 0; i < 12; ++i) {
    play_a_little(first, 1);
    EXPECT_GT(at_once.bytes.size(), before);
    before = at_once.bytes.size();
    play_a_little(second, 1);
  }
  EXPECT_EQ(slow.updates(), 12u) << "waits for all";
  EXPECT_EQ(slow.bytes(), behind.bytes.size());
  recorder.finish(), slow.finish();
  EXPECT_EQ(most, 1);
  EXPECT_EQ(behind.bytes, at_once.bytes);
  EXPECT_EQ(steps_of(behind.bytes).size(), 12u);
}

// It is called by the thread that writes, which must not wait for itself.
TEST(WorldRecorder, ASinkMayAskWhatIsWritten) {
  for (const RecordedWriting writing : {RecordedWriting::AtOnce, RecordedWriting::Behind}) {
    World world;
    WorldRecorder* asked = nullptr;
    std::vector<std::size_t> updates;
    std::size_t bytes = 0;
    WorldRecorder recorder(world,
                           [&](std::string_view block) {
                             if (asked != nullptr) {
                               updates.push_back(asked->updates());
                               EXPECT_EQ(asked->bytes(), bytes);
                               EXPECT_FALSE(asked->has_failed());
                             }
                             bytes += block.size();
                           },
                           {.writing = writing});
    asked = &recorder;
    play_a_little(world, 3);
    recorder.finish();
    EXPECT_EQ(updates, (std::vector<std::size_t>{0, 1, 2, 3}));  // the last one is the end
    EXPECT_EQ(recorder.bytes(), bytes);
  }
}

}  // namespace
}  // namespace graze::tests
