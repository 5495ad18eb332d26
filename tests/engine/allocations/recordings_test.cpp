// A world that is recorded while its n-th allocation fails: the world goes on, and the recording is
// whole or says that it is not.

#include <graze/engine/record/read_recording.h>
#include <graze/engine/record/world_recorder.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <memory>
#include <sstream>
#include <string>
#include <string_view>

#include "tests/engine/allocations/failing_new.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"

namespace graze::tests {
namespace {

struct RecordedFall {
  std::string bytes;
  std::size_t pairs = 0;     ///< told by all updates
  bool has_failed = false;   ///< some allocation
  bool is_recorded = false;  ///< finish() threw nothing
};

/// Four balls that come down on a box, one after the other, with the n-th allocation failing.
RecordedFall fall(RecordedWriting writing, long n, long* count = nullptr) {
  static const Mesh box = make_box({2, 2, 0.5});
  RecordedFall result;
  result.bytes.reserve(1 << 16);
  World world;
  const BodyId floor = world.add({Shape(box), at(0)});
  WorldRecorder recorder(world, [&](std::string_view more) { result.bytes += more; },
                         {.contacts = RecordedContacts::All, .writing = writing});
  const FailingNew armed(n);
  for (int step = 0; step < 12; ++step) {
    const auto again = [&](const auto& task) {  // what fails has not happened
      try {
        task();
      } catch (const std::bad_alloc&) {
        task();
      }
    };
    if (step % 3 == 0)
      again([&] { world.add({Sphere{{0, 0, 0}, 0.5}, at(0.25 * step - 1, 0, 0.75)}); });
    if (step == 7) again([&] { recorder.name(floor, "the floor"); });
    again([&] { result.pairs += world.update().begun.size(); });
  }
  try {
    recorder.finish();
    result.is_recorded = true;
    EXPECT_FALSE(recorder.has_failed());
  } catch (const std::bad_alloc&) {
    EXPECT_TRUE(recorder.has_failed());
  }
  result.has_failed = armed.has_failed();
  if (count != nullptr) *count = armed.calls();
  return result;
}

std::size_t begun_in(const std::string& bytes) {
  RecordingReader reader(std::make_unique<std::istringstream>(bytes), "recorded");
  std::size_t begun = 0;
  while (const RecordedStep* step = reader.next())
    begun += step->answers.begun.size();
  EXPECT_EQ(reader.end(), RecordingEnd::Complete);
  return begun;
}

TEST(Allocations, OfRecordingsMayFail) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  for (const RecordedWriting writing : {RecordedWriting::AtOnce, RecordedWriting::Behind}) {
    long count = 0;
    fall(writing, FailingNew::kNever);  // threads keep some memory
    const RecordedFall whole = fall(writing, FailingNew::kNever, &count);
    ASSERT_TRUE(whole.is_recorded);
    ASSERT_EQ(begun_in(whole.bytes), whole.pairs);
    EXPECT_GT(count, 20);
    long lost = 0, kept = 0;
    for (long n = 1; n <= count; ++n) {
      SCOPED_TRACE("allocation " + std::to_string(n));
      const RecordedFall fallen = fall(writing, n);
      ASSERT_EQ(fallen.pairs, whole.pairs);
      lost += !fallen.is_recorded;
      kept += fallen.is_recorded && fallen.has_failed;
      if (fallen.is_recorded) {
        ASSERT_EQ(begun_in(fallen.bytes), whole.pairs);
      }
      if (HasFailure()) return;
    }
    EXPECT_GT(lost, 5);
    EXPECT_GT(kept, 5);
  }
}

}  // namespace
}  // namespace graze::tests
