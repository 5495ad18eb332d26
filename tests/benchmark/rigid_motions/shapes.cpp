#include "tests/benchmark/rigid_motions/shapes.h"

#include <graze/engine/world/shape_motion.h>
#include <graze/engine/world/shape_pairs.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "tests/benchmark/common/median.h"
#include "tests/benchmark/common/thread_clock.h"
#include "tests/benchmark/rigid_motions/peers/peers.h"
#include "tests/shapes/random_meshes.h"

namespace graze::benchmark {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// What a peer may be late by, of the whole motion, ten times what FCL promises by default.
constexpr double kLate = 1e-3;

/// FCL's advancement knows no ellipsoids.
const std::vector<Shape>& shapes() {
  static const std::vector<Shape> kShapes = {Sphere{{0, 0, 0}, 0.4}, Box{{0.4, 0.3, 0.2}},
                                             Capsule{0.2, 0.3}, Cylinder{0.3, 0.3},
                                             Cone{0.35, 0.35}};
  return kShapes;
}

Ends random_ends(RandomSource& source) {
  const Pose start = tests::random_pose(1.2, source);
  Pose end = start;
  const Eigen::Vector3d axis = source.vector(-1, 1).normalized();
  end.linear() = Eigen::AngleAxisd(source.uniform(-1, 1), axis).toRotationMatrix() * start.linear();
  end.translation() += source.vector(-1.5, 1.5);
  return {start, end};
}

struct PeerScore {
  std::string name;
  AskMotions ask;
  std::vector<double> ours, theirs;  ///< microseconds, where they are right
  std::size_t missed = 0, late = 0, not_there = 0;
};

/// The least of three runs, microseconds.
template <typename Run>
double time_of(const Run& run) {
  double least = kNever;
  for (int i = 0; i < 3; ++i) {
    const ThreadClock clock;
    run();
    least = std::min(least, clock.nanoseconds() * 1e-3);
  }
  return least;
}

void judge(PeerScore& peer, const Ends& a, const Ends& b, const RigidContact& truth, double ours) {
  double said = kNever;
  const double theirs = time_of([&] { said = peer.ask(a, b); });
  const bool is_hit = truth.status == RigidStatus::Hit, says_hit = said != kNever;
  if (truth.status == RigidStatus::Close) return;
  if (is_hit && !says_hit) {
    ++peer.missed;
  } else if (!is_hit && says_hit) {
    ++peer.not_there;
  } else if (is_hit && said > truth.high + kLate) {
    ++peer.late;
  } else {
    peer.ours.push_back(ours);
    peer.theirs.push_back(theirs);
  }
}

std::size_t refuted(const Shape& shape_a, const RigidMotion& a, const Shape& shape_b,
                    const RigidMotion& b, const RigidContact& answer) {
  const auto touch = [&](double t) { return intersects({shape_a, a.at(t)}, {shape_b, b.at(t)}); };
  std::size_t wrong = answer.status == RigidStatus::Hit && !touch(answer.high);
  for (int i = 0; i <= 200; ++i)
    wrong += i / 200.0 < answer.low && touch(i / 200.0);
  return wrong;
}

}  // namespace

nlohmann::ordered_json measure_shape_motions(int motions, std::size_t& wrong) {
  std::vector<ShapePeer> known;
  for (const Peer& peer : peers())
    peer.add(known);
  for (const std::string& name : absent_peers())
    std::printf("%s was not found and takes no part\n", name.c_str());
  std::vector<PeerScore> scores;
  for (const ShapePeer& peer : known)
    scores.push_back({peer.name, {}, {}, {}});
  RandomSource source(31);
  std::vector<double> free, hit;
  for (std::size_t i = 0; i < shapes().size(); ++i) {
    for (std::size_t k = i; k < shapes().size(); ++k) {
      const Shape &shape_a = shapes()[i], &shape_b = shapes()[k];
      for (std::size_t p = 0; p < known.size(); ++p)
        scores[p].ask = known[p].load(shape_a, shape_b);
      for (int n = 0; n < motions; ++n) {
        const Ends ends_a = random_ends(source), ends_b = random_ends(source);
        const RigidMotion a = RigidMotion::between(ends_a.start, ends_a.end);
        const RigidMotion b = RigidMotion::between(ends_b.start, ends_b.end);
        RigidContact found{};
        const double ours = time_of([&] { found = first_contact({shape_a, a}, {shape_b, b}); });
        wrong += refuted(shape_a, a, shape_b, b, found);
        (found.status == RigidStatus::Free ? free : hit).push_back(ours);
        for (PeerScore& peer : scores)
          judge(peer, ends_a, ends_b, found, ours);
      }
    }
  }
  std::printf("\nconvex shapes: free %zu motions, median %.1f us; hit %zu, %.1f us\n", free.size(),
              median(free), hit.size(), median(hit));
  nlohmann::ordered_json document{{"free", free.size()},
                                  {"free_microseconds", median(free)},
                                  {"hit", hit.size()},
                                  {"hit_microseconds", median(hit)},
                                  {"peers", nlohmann::ordered_json::array()}};
  for (const PeerScore& peer : scores) {
    if (peer.ours.empty()) continue;
    std::printf("  %-18s missed %zu, late %zu, not there %zu; where right %.1f us, graze %.1f us\n",
                peer.name.c_str(), peer.missed, peer.late, peer.not_there, median(peer.theirs),
                median(peer.ours));
    document["peers"].push_back({{"peer", peer.name},
                                 {"missed", peer.missed},
                                 {"late", peer.late},
                                 {"not_there", peer.not_there},
                                 {"microseconds", median(peer.theirs)},
                                 {"graze_microseconds", median(peer.ours)}});
  }
  return document;
}

}  // namespace graze::benchmark
