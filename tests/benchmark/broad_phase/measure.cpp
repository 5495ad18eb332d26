#include "tests/benchmark/broad_phase/measure.h"

#include <graze/engine/world/broad_phase.h>
#include <time.h>

#include "tests/benchmark/broad_phase/scenes.h"

namespace graze::benchmark {
namespace {

constexpr std::size_t kFewFrames = 7;

double milliseconds(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// A sum over the pairs: pairs that are missing, wrong or there twice change it.
std::uint64_t number_of(const Contestant& contestant, std::span<const BoxPair> pairs) {
  std::uint64_t sum = pairs.size();
  for (const BoxPair& named : pairs) {
    const BoxPair pair = ordered_pair(contestant.number(named.a), contestant.number(named.b));
    std::uint64_t z = (static_cast<std::uint64_t>(pair.a) << 32 | pair.b) * 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 32) * 0xbf58476d1ce4e5b9u;
    sum += z ^ z >> 29;
  }
  return sum;
}

}  // namespace

Score measure(const Entry& entry, const Course& course, Truth& truth) {
  const clockid_t clock = entry.threads == 1 ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC;
  const auto scene = make_scene(course.scene, course.boxes, 1);
  const auto contestant = entry.make();
  Score score;
  const double start = milliseconds(clock);
  contestant->start(scene->boxes());
  score.start = milliseconds(clock) - start;
  score.scene = course.scene, score.contestant = entry.name, score.boxes = course.boxes;
  std::vector<double> times;
  for (int frame = 0; frame < course.frames; ++frame) {
    scene->next_frame();
    const double begin = milliseconds(clock);
    const std::span<const BoxPair> pairs = scene->change() == Scene::Change::IsReplaced
                                               ? contestant->replace(scene->boxes(), scene->moved())
                                               : contestant->step(scene->boxes(), scene->moved());
    times.push_back(milliseconds(clock) - begin);
    score.pairs = pairs.size();
    const std::uint64_t number = number_of(*contestant, pairs);
    if (truth.size() == static_cast<std::size_t>(frame)) truth.push_back(number);
    score.wrong_frames += truth[static_cast<std::size_t>(frame)] != number;
    score.mean += times.back();
    score.slowest = std::max(score.slowest, times.back());
    if (times.back() > course.patience) break;
    if (times.size() >= kFewFrames && score.mean > course.budget) break;
  }
  score.frames = static_cast<int>(times.size());
  score.mean /= static_cast<double>(times.size());
  score.median = median(times);
  score.bytes_per_box = static_cast<double>(contestant->bytes()) / course.boxes;
  return score;
}

double measure_movers(std::uint32_t boxes, std::uint32_t count, int frames) {
  const auto scene = make_scene("S1", boxes, 1);
  BroadPhase broad;
  std::vector<BoxId> ids;
  for (const Aabb& box : scene->boxes())
    ids.push_back(broad.add(box));
  broad.update();
  Random random(5);
  std::vector<double> times;
  for (int frame = 0; frame < frames + 3; ++frame) {
    for (std::uint32_t k = 0; k < count; ++k) {
      const BoxId id = ids[random.bits() % boxes];
      Aabb box = broad.box(id);
      const Eigen::Vector3d step = random.point(0.1);
      box.min += step, box.max += step;
      broad.move(id, box);
    }
    const double begin = milliseconds(CLOCK_THREAD_CPUTIME_ID);
    broad.update();
    if (frame >= 3) times.push_back(1e3 * (milliseconds(CLOCK_THREAD_CPUTIME_ID) - begin));
  }
  return median(times);
}

}  // namespace graze::benchmark
