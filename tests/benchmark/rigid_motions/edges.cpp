#include "tests/benchmark/rigid_motions/edges.h"

#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/pair.h>

#include <algorithm>

#include "tests/benchmark/common/thread_clock.h"
#include "tests/shapes/random_source.h"

namespace graze::benchmark {
namespace {

constexpr int kSamples = 100;

/// The lesser of two runs, microseconds.
template <typename Run>
double time_of(const Run& run) {
  double least = 0;
  for (int i = 0; i < 2; ++i) {
    const ThreadClock clock;
    run();
    const double taken = clock.nanoseconds() / 1000;
    least = i == 0 ? taken : std::min(least, taken);
  }
  return least;
}

/// How many samples hit before a time.
std::size_t hits_before(const Scene& scene, const RigidMotion& motion, double end) {
  std::size_t hits = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double t = i / (kSamples - 1.0);
    hits += t < end && intersects({scene.mesh_a}, {scene.mesh_b, motion.at(t)});
  }
  return hits;
}

/// Conservative advancement: as far as the distance lasts at the greatest speed, again and again.
double advanced(const Scene& scene, const RigidMotion& motion, double tolerance) {
  double radius = 0;
  for (const Eigen::Vector3d& vertex : scene.mesh_b.vertices())
    radius = std::max(radius, (motion.start() * vertex - motion.centre()).norm());
  const double speed = motion.shift().norm() + motion.angle() * radius;
  double t = 0;
  while (t < 1) {
    const double gap = distance({scene.mesh_a}, {scene.mesh_b, motion.at(t)}).distance;
    if (gap <= tolerance) return t;
    t += gap / speed;
  }
  return 1;
}

void measure(const Scene& scene, const RigidMotion& motion, double tolerance, EdgeResult& result) {
  const RigidMotion rest(Pose::Identity());
  RigidContact found{};
  const double taken = time_of([&] {
    found = first_contact({scene.mesh_a, rest}, {scene.mesh_b, motion}, {.tolerance = tolerance});
  });
  result.wrong += hits_before(scene, motion, found.low) > 0;
  if (found.status == RigidStatus::Free) {
    result.free.first_contact.push_back(taken);
    result.free.other.push_back(time_of([&] { hits_before(scene, motion, 2); }));
  } else if (found.status == RigidStatus::Hit) {
    result.hit.first_contact.push_back(taken);
    result.hit.other.push_back(time_of([&] { advanced(scene, motion, tolerance); }));
    result.wrong += !intersects({scene.mesh_a}, {scene.mesh_b, motion.at(found.high)});
  } else {
    ++result.close;
  }
}

}  // namespace

EdgeResult measure_edges(const Scene& scene, const RegimePoses& regime,
                         const EdgeSettings& settings) {
  const double size = scene.size();
  const Eigen::Vector3d middle = (scene.mesh_b.bounds().min + scene.mesh_b.bounds().max) / 2;
  RandomSource source(settings.seed);
  EdgeResult result;
  for (std::size_t i = 0; i < settings.count; ++i) {
    const Pose& start = regime.poses[i % regime.poses.size()];
    const Eigen::Vector3d shift = settings.reach * size * source.vector(-1, 1);
    const Eigen::Vector3d axis = source.vector(-1, 1);
    const RigidMotion motion(start, {.centre = start * middle,
                                     .shift = shift,
                                     .axis = axis,
                                     .angle = source.uniform(0, settings.turn)});
    measure(scene, motion, settings.tolerance * size, result);
  }
  return result;
}

}  // namespace graze::benchmark
