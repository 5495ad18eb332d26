#include "tests/benchmark/motion/paths.h"

#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/pair.h>

#include <optional>

#include "tests/shapes/random_source.h"

namespace graze::benchmark {
namespace {

constexpr int kTries = 20;
constexpr double kSlack = 2;

/// How far from touching: a distance, or so many pairs.
struct State {
  std::size_t pairs;
  double distance;
};

class Mover {
 public:
  Mover(const Scene& scene, const PathSettings& settings, std::uint64_t seed)
      : scene_(scene),
        settings_(settings),
        source_(seed),
        middle_(0.5 * (scene.mesh_b.bounds().min + scene.mesh_b.bounds().max)) {
    const double radius = 0.5 * (scene.mesh_b.bounds().max - scene.mesh_b.bounds().min).norm();
    angle_ = settings.turn * scene.size() / radius;
  }

  Path path_from(const Pose& start) {
    Path path{start};
    const State first = state_in(start);
    turn_off();
    while (path.size() <= settings_.steps) {
      std::optional<Pose> next;
      for (int i = 0; i < kTries && !next; ++i) {
        if (i > 0) turn_off();
        const Pose pose = stepped(path.back());
        if (is_alike(first, state_in(pose))) next = pose;
      }
      if (!next) break;
      path.push_back(*next);
    }
    return path;
  }

 private:
  State state_in(const Pose& pose) const {
    const PlacedMeshView a{scene_.mesh_a};
    const PlacedMeshView b{scene_.mesh_b, pose};
    const std::size_t pairs = find_triangle_pairs(a, b).size();
    return {pairs, pairs > 0 ? 0 : distance(a, b).distance};
  }

  static bool is_alike(const State& one, const State& other) {
    const auto is_near = [](double x, double y) { return x <= kSlack * y && y <= kSlack * x; };
    return is_near(one.distance, other.distance) &&
           is_near(static_cast<double>(one.pairs), static_cast<double>(other.pairs));
  }

  void turn_off() {
    direction_ = random_direction();
    axis_ = random_direction();
  }

  Eigen::Vector3d random_direction() {
    Eigen::Vector3d direction;
    do {
      direction = source_.vector(-1, 1);
    } while (direction.norm() > 1 || direction.norm() < 0.1);
    return direction.normalized();
  }

  Pose stepped(const Pose& pose) const {
    const Eigen::Vector3d middle = pose * middle_ + settings_.step * scene_.size() * direction_;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle_, axis_));
    Pose next = pose;
    next.linear() = (turn * Eigen::Quaterniond(pose.linear())).normalized().toRotationMatrix();
    next.translation() = middle - next.linear() * middle_;
    return next;
  }

  const Scene& scene_;
  const PathSettings& settings_;
  RandomSource source_;
  Eigen::Vector3d middle_;
  double angle_;
  Eigen::Vector3d direction_;
  Eigen::Vector3d axis_;
};

}  // namespace

std::vector<Path> paths_in(const Scene& scene, const RegimePoses& regime,
                           const PathSettings& settings) {
  std::vector<Path> paths;
  for (std::size_t i = 0; i < settings.count && i < regime.poses.size(); ++i)
    paths.push_back(Mover(scene, settings, settings.seed + i).path_from(regime.poses[i]));
  return paths;
}

}  // namespace graze::benchmark
