// Nanoseconds a question for each pair of kinds of shape, beside FCL: yes or no, contacts,
// distance. Shapes of about one metre at random, half of them apart by up to 5 cm, half overlapping
// by as much: what a broad phase hands on. Prints a table.

#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <vector>

#include "tests/crosscheck/fcl_shape_opinion.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/shape_kinds.h"

namespace graze {
namespace {

struct Placed {
  Shape a;
  Shape b;
  Pose pose_a;
  Pose pose_b;
};

/// Nanoseconds of this thread's processor time.
double processor_time() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e9 + static_cast<double>(time.tv_nsec);
}

/// Brought together until they nearly touch, then moved by at most 5 cm either way.
Placed near_touching(ShapeKind kind_a, ShapeKind kind_b, RandomSource& source) {
  Placed pair{tests::random_shape(kind_a, 1, source), tests::random_shape(kind_b, 1, source),
              tests::random_pose(1, source), tests::random_pose(1, source)};
  const Eigen::Vector3d way = source.vector(-1, 1).normalized();
  const double far = tests::size_of(pair.a) + tests::size_of(pair.b);
  pair.pose_b.translation() = pair.pose_a.translation() + way * far;
  for (int step = 0; step < 20 && kind_b != ShapeKind::HalfSpace; ++step) {
    const double gap = distance({pair.a, pair.pose_a}, {pair.b, pair.pose_b}).distance;
    if (gap < 1e-3) break;
    pair.pose_b.translation() -= way * gap;
  }
  pair.pose_b.translation() += way * source.uniform(-0.05, 0.05);
  return pair;
}

/// The least of seven runs, a pair.
template <typename Ask>
double time_of(std::size_t count, Ask&& ask) {
  double least = std::numeric_limits<double>::infinity();
  double sum = 0;  // of all answers, so that none is left out
  for (int run = 0; run < 7; ++run) {
    const double begin = processor_time();
    for (std::size_t i = 0; i < count; ++i)
      sum += ask(i);
    least = std::min(least, processor_time() - begin);
  }
  if (sum < 0) std::puts("negative");
  return least / static_cast<double>(count);
}

void report(ShapeKind kind_a, ShapeKind kind_b, RandomSource& source) {
  constexpr std::size_t kPairs = 300;
  std::vector<Placed> pairs;
  std::vector<tests::FclPair> of_fcl;
  for (std::size_t i = 0; i < kPairs; ++i) {
    pairs.push_back(near_touching(kind_a, kind_b, source));
    const Placed& p = pairs.back();
    of_fcl.emplace_back(p.a, p.pose_a, p.b, p.pose_b);
  }
  const auto graze_time = [&](auto&& ask) {
    return time_of(kPairs, [&](std::size_t i) { return static_cast<double>(ask(pairs[i])); });
  };
  const auto fcl_time = [&](auto&& ask) {
    return time_of(kPairs, [&](std::size_t i) { return static_cast<double>(ask(of_fcl[i])); });
  };
  const double yes = graze_time([](const Placed& p) {
    return intersects({p.a, p.pose_a}, {p.b, p.pose_b});
  });
  const double contacts = graze_time([](const Placed& p) {
    return find_contacts({p.a, p.pose_a}, {p.b, p.pose_b}).size();
  });
  const double apart = graze_time([](const Placed& p) {
    return distance({p.a, p.pose_a}, {p.b, p.pose_b}).distance;
  });
  const double fcl_yes = fcl_time([](const tests::FclPair& p) { return p.intersects(); });
  const double fcl_contacts = fcl_time([](const tests::FclPair& p) { return p.contacts().is_hit; });
  const bool has_distance = kind_b != ShapeKind::HalfSpace && kind_b != ShapeKind::Mesh;
  const double fcl_apart =
      has_distance ? fcl_time([](const tests::FclPair& p) { return std::abs(p.distance()); }) : 0;
  std::printf("%-11s %-11s | %7.0f %7.0f | %7.0f %7.0f | %7.0f ", name_of(kind_a), name_of(kind_b),
              yes, fcl_yes, contacts, fcl_contacts, apart);
  if (has_distance) {
    std::printf("%7.0f\n", fcl_apart);
  } else {
    std::printf("%7s\n", "-");
  }
}

}  // namespace
}  // namespace graze

int main() {
  std::puts("ns a pair, graze and FCL   |      yes or no  |       contacts  |       distance");
  graze::RandomSource source(3);
  for (std::size_t i = 0; i < 7; ++i) {
    for (std::size_t j = i; j < 9; ++j)
      graze::report(graze::tests::kOwnKinds[i], graze::tests::kOwnKinds[j], source);
  }
}
