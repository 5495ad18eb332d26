// What a world did, in a file: read, repeated, and held against another run.

#include <graze/engine/record/read_recording.h>
#include <graze/engine/record/replay_recording.h>
#include <graze/engine/record/world_recorder.h>
#include <graze/engine/version.h>

#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>

#include "samples/examples/example.h"

using examples::expect;

namespace {

/// A ball that comes down on a cube.
void run(graze::World& world, const graze::BodyId ball) {
  for (int step = 0; step < 5; ++step) {
    world.move(ball, examples::at(0.5, 0.5, 3 - 0.5 * step));
    world.update();
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;  // a folder to write to
  const std::filesystem::path file = std::filesystem::path(argv[1]) / "ball.recording";

  graze::World world;
  graze::WorldRecorder recorder(world, file, {.contacts = graze::RecordedContacts::All});
  world.add({examples::cube(1)}, {.kind = graze::BodyKind::Static});
  const graze::BodyId ball = world.add({graze::Sphere{{0, 0, 0}, 0.5}, examples::at(0, 0, 9)});
  recorder.name(ball, "ball");
  run(world, ball);
  recorder.finish();
  expect(!recorder.has_failed() && recorder.updates() == 5, "five updates were written");
  expect(recorder.bytes() == std::filesystem::file_size(file), "they are that file");

  // What was done and said, update by update.
  graze::RecordingReader reader(file);
  expect(reader.head().engine_version == graze::library_version(), "this graze wrote it");
  expect(reader.start().bodies.empty(), "the world was empty when it began");
  std::size_t begun = 0;
  while (const graze::RecordedStep* step = reader.next())
    begun += step->answers.begun.size();
  expect(begun == 1, "the ball came to touch the cube");
  expect(reader.end() == graze::RecordingEnd::Complete, "its writer has come to the end");
  expect(reader.shape_count() == 2 && reader.shape(1)->shape() != nullptr, "a cube and a ball");
  expect(reader.bytes() == recorder.bytes(), "all of it was read");

  // The same once more, with other threads.
  graze::RecordingReplay replay(graze::RecordingReader{file}, {.threads = 2});
  while (replay.advance())
    expect(!replay.difference(), "it says the same");
  expect(replay.update().begun.size() == replay.step().answers.begun.size(), "and as much");
  expect(replay.step().number == 4 && replay.world().size() == 2, "up to the last update");
  expect(replay.reader().end() == graze::RecordingEnd::Complete, "and there it ends");

  // To wherever bytes go, and held against the first.
  auto bytes = std::make_unique<std::stringstream>();
  graze::World other;
  graze::WorldRecorder second(other, [&](std::string_view more) { *bytes << more; });
  other.add({examples::cube(2)}, {.kind = graze::BodyKind::Static});
  run(other, other.add({graze::Sphere{{0, 0, 0}, 0.5}, examples::at(0, 0, 9)}));
  second.finish();
  graze::RecordingReader first(file), larger(std::move(bytes), "larger");
  std::size_t differing = 0;
  while (true) {
    const graze::RecordedStep* a = first.next();
    const graze::RecordedStep* b = larger.next();
    if (a == nullptr || b == nullptr) break;
    if (a->number > 0)
      expect(!graze::first_difference(a->number, a->changes, b->changes), "the ball goes alike");
    if (graze::first_difference(a->number, a->answers, b->answers)) ++differing;
  }
  expect(differing > 0, "a larger cube is touched sooner");
  expect(graze::answers_of(world.update(), graze::RecordedContacts::None, false).begun.empty(),
         "nothing moved since");
  std::filesystem::remove(file);
}
