#include "tests/benchmark/common/pose_regimes.h"

#include <graze/bvh/error.h>
#include <graze/engine/mesh/pair.h>

#include <algorithm>
#include <optional>

#include "tests/shapes/random_meshes.h"

namespace graze::benchmark {
namespace {

constexpr int kMarchSteps = 200;
constexpr int kBisections = 30;
constexpr int kMaxMisses = 100;

Eigen::Vector3d centre_of(const Mesh& mesh) {
  return 0.5 * mesh.bounds().min + 0.5 * mesh.bounds().max;
}

double radius_of(const Mesh& mesh) {
  return 0.5 * (mesh.bounds().max - mesh.bounds().min).norm();
}

/// B on its way towards A.
class Approach {
 public:
  Approach(const Mesh& mesh_a, const Mesh& mesh_b, RandomSource& source)
      : mesh_a_(mesh_a), mesh_b_(mesh_b), turned_(tests::random_pose(0, source)) {
    do {
      direction_ = source.vector(-1, 1);
    } while (direction_.norm() > 1 || direction_.norm() < 0.1);
    direction_.normalize();
  }

  /// The centres are `distance` apart.
  Pose at(double distance) const {
    Pose pose = turned_;
    pose.translation() =
        centre_of(mesh_a_) + distance * direction_ - turned_.linear() * centre_of(mesh_b_);
    return pose;
  }

  /// The largest distance, to within a billionth, at which marching steps find the surfaces to
  /// meet.
  std::optional<double> touching_distance() const {
    const double reach = radius_of(mesh_a_) + radius_of(mesh_b_);
    double apart = reach * 1.001;
    for (int i = 1; i <= kMarchSteps; ++i) {
      double meeting = reach * (kMarchSteps - i) / kMarchSteps;
      if (!do_meet(meeting)) {
        apart = meeting;
        continue;
      }
      for (int k = 0; k < kBisections; ++k) {
        const double middle = 0.5 * (apart + meeting);
        (do_meet(middle) ? meeting : apart) = middle;
      }
      return meeting;
    }
    return std::nullopt;
  }

 private:
  bool do_meet(double distance) const { return intersects({mesh_a_}, {mesh_b_, at(distance)}); }

  const Mesh& mesh_a_;
  const Mesh& mesh_b_;
  Pose turned_;
  Eigen::Vector3d direction_;
};

/// By how much of the size B is moved back from where it touches.
double retreat(Regime regime, std::size_t index, RandomSource& source) {
  constexpr std::array kGaps{0.001, 0.01, 0.05};
  switch (regime) {
    case Regime::Far:
      return 2 + source.uniform(0, 2);
    case Regime::Near:
      return kGaps[index % kGaps.size()];
    case Regime::Touch:
      return -source.uniform(0.001, 0.01);
    case Regime::Deep:
      return -source.uniform(0.1, 0.4);
  }
  throw InputError("there is no such regime");
}

}  // namespace

const char* name_of(Regime regime) {
  switch (regime) {
    case Regime::Far:
      return "far";
    case Regime::Near:
      return "near";
    case Regime::Touch:
      return "touch";
    case Regime::Deep:
      return "deep";
  }
  throw InputError("there is no such regime");
}

std::vector<Pose> poses_in(Regime regime, const Mesh& mesh_a, const Mesh& mesh_b,
                           const PoseSettings& settings) {
  RandomSource source(settings.seed);
  const double size = std::min(radius_of(mesh_a), radius_of(mesh_b));
  std::vector<Pose> poses;
  int misses = 0;
  while (poses.size() < settings.count) {
    const Approach approach(mesh_a, mesh_b, source);
    const std::optional<double> touching = approach.touching_distance();
    if (!touching && ++misses == kMaxMisses) throw InputError("poses: B never meets A");
    if (!touching) continue;
    misses = 0;
    poses.push_back(approach.at(*touching + size * retreat(regime, poses.size(), source)));
  }
  return poses;
}

}  // namespace graze::benchmark
