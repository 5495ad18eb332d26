#include "tests/stress/flip.h"

#include <graze/engine/mesh/pair.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "tests/stress/fcl_peer.h"
#include "tests/stress/placed_truth.h"

namespace graze::stress {
namespace {

// Metres: far above what a thousand doubles move a mesh of less than a metre, and the rounding of
// its coordinates; far below the size of its triangles.
constexpr double kMargin = 1e-10;

}  // namespace

Pose pose_at(const BundledPair& pair, double value) {
  Pose pose = pair.apart;
  pose.translation()[pair.axis] = value;
  return pose;
}

Flip find_flip(const BundledPair& pair) {
  const auto is_hit = [&](double value) {
    return intersects({pair.mesh_a, pair.pose_a}, {pair.mesh_b, pose_at(pair, value)},
                      {.volume = PairVolume::Obb});
  };
  Flip flip{pair.apart.translation()[pair.axis], 0};
  if (is_hit(flip.apart)) throw std::logic_error(pair.name + ": begins with a hit");
  flip.hit = flip.apart + pair.step;
  for (int i = 1; !is_hit(flip.hit); ++i) {
    if (i == 100) throw std::logic_error(pair.name + ": no hit found");
    flip.apart = flip.hit;
    flip.hit += pair.step;
  }
  while (true) {
    const double middle = flip.apart + (flip.hit - flip.apart) / 2;
    if (middle == flip.apart || middle == flip.hit) return flip;
    (is_hit(middle) ? flip.hit : flip.apart) = middle;
  }
}

FlipReport report_flip(const BundledPair& pair, const Flip& flip, std::size_t poses) {
  const PlacedMesh placed_a{pair.mesh_a, pair.pose_a};
  const std::vector<TrianglePair> near =
      near_pairs(placed_a, {pair.mesh_b, pose_at(pair, flip.hit)}, kMargin);
  const std::unique_ptr<Peer> fcl = make_fcl_peer(pair.mesh_a, pair.mesh_b);
  FlipReport report;
  report.near = near.size();
  report.has_fcl = fcl != nullptr;
  double value = flip.apart;
  for (std::size_t i = 0; 2 * i + 2 < poses; ++i)
    value = std::nextafter(value, flip.apart > flip.hit ? HUGE_VAL : -HUGE_VAL);
  bool was_hit = false;
  for (std::size_t i = 0; i < poses; ++i) {
    const Pose pose = pose_at(pair, value);
    const bool truth = is_any_hit(near, placed_a, {pair.mesh_b, pose});
    const bool graze = intersects(placed_a, {pair.mesh_b, pose}, {.volume = PairVolume::Obb});
    report.hits += truth;
    report.changes += i > 0 && truth != was_hit;
    report.graze_wrong += graze != truth;
    if (fcl) report.fcl_wrong += fcl->intersects(placed_a.pose, pose) != truth;
    was_hit = truth;
    value = std::nextafter(value, flip.apart > flip.hit ? -HUGE_VAL : HUGE_VAL);
  }
  report.poses = poses;
  return report;
}

}  // namespace graze::stress
