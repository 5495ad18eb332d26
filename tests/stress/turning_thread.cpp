#include "tests/stress/turning_thread.h"

#include <graze/bvh/error.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/pair.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <thread>

#include "tests/stress/placed_truth.h"

namespace graze::stress {
namespace {

constexpr double kPitch = 1.25e-3;           // of an M8 thread, metres
constexpr double kStartHeight = 7 * kPitch;  // where the bundled poses begin, too
constexpr double kTurns = 2;
constexpr double kStep = 0.01;  // radians

// Metres: some hundred times less than the clearance of the thread, a million times the rounding.
constexpr double kMargin = 1e-7;

/// The step as float holds it. Its columns are not of length 1, and the thread follows its angle.
struct FloatStep {
  double cosine = static_cast<double>(static_cast<float>(std::cos(kStep)));
  double sine = static_cast<double>(static_cast<float>(std::sin(kStep)));
  double angle() const { return std::atan2(sine, cosine); }
};

Eigen::Matrix3d step_matrix(double direction) {
  const FloatStep step;
  Eigen::Matrix3d matrix;
  matrix << step.cosine, -direction * step.sine, 0, direction * step.sine, step.cosine, 0, 0, 0, 1;
  return matrix;
}

/// Gram and Schmidt's.
Eigen::Matrix3d orthonormal(const Eigen::Matrix3d& m) {
  Eigen::Matrix3d result;
  result.col(0) = m.col(0).normalized();
  result.col(1) = (m.col(1) - result.col(0).dot(m.col(1)) * result.col(0)).normalized();
  result.col(2) = result.col(0).cross(result.col(1));
  return result;
}

/// Queries of poses that come in blocks, by all processors.
class ParallelQueries {
 public:
  ParallelQueries(const Mesh& bolt, const Mesh& nut) : bolt_(bolt), nut_(nut) {}

  std::size_t count_hits(const std::vector<Pose>& poses) const {
    std::atomic<std::size_t> next = 0;
    std::atomic<std::size_t> hits = 0;
    const auto work = [&] {
      for (std::size_t i = next++; i < poses.size(); i = next++)
        hits += intersects({bolt_}, {nut_, poses[i]}, {.volume = Volume::Obb});
    };
    std::vector<std::thread> threads(std::max(1u, std::thread::hardware_concurrency()));
    for (std::thread& thread : threads)
      thread = std::thread(work);
    for (std::thread& thread : threads)
      thread.join();
    return hits;
  }

 private:
  const Mesh& bolt_;
  const Mesh& nut_;
};

bool is_right(const Mesh& bolt, const Mesh& nut, const Pose& pose) {
  const bool truth = is_any_hit(near_pairs({bolt}, {nut, pose}, kMargin), {bolt}, {nut, pose});
  return intersects({bolt}, {nut, pose}) == truth;
}

}  // namespace

TurningNut::TurningNut() = default;

Pose TurningNut::pose() const {
  Pose result = Pose::Identity();
  result.linear() = rotation_;
  result.translation().z() = kStartHeight + kPitch * angle_ / (2 * std::numbers::pi);
  return result;
}

Pose TurningNut::next() {
  const double end = -2 * std::numbers::pi * kTurns;
  if (angle_ < end) direction_ = 1;
  if (angle_ > 0) direction_ = -1;
  rotation_ = step_matrix(direction_) * rotation_;
  angle_ += direction_ * FloatStep().angle();
  try {
    largest_deviation_ = std::max(largest_deviation_, check_rigid(pose(), "nut"));
  } catch (const PoseError&) {
    rotation_ = orthonormal(rotation_);
    ++renormalised_;
    largest_deviation_ = std::max(largest_deviation_, check_rigid(pose(), "nut"));
  }
  return pose();
}

TurningReport turn_nut(const std::filesystem::path& data, std::size_t steps,
                       std::size_t spot_checks) {
  const Mesh bolt = load_mesh(data / "meshes/bolt.obj");
  const Mesh nut = load_mesh(data / "meshes/nut.stl");
  const ParallelQueries queries(bolt, nut);
  const std::size_t between =
      std::max<std::size_t>(1, steps / std::max<std::size_t>(1, spot_checks));
  TurningNut turning;
  TurningReport report;
  std::vector<Pose> block;
  for (std::size_t i = 0; i < steps; ++i) {
    block.push_back(turning.next());
    if (i % between == between / 2) {
      Pose shifted = block.back();
      shifted.translation().z() += kPitch / 8;
      report.spot_wrong += !is_right(bolt, nut, block.back());
      report.shifted_wrong += !is_right(bolt, nut, shifted) || !intersects({bolt}, {nut, shifted});
      ++report.spot_checks;
    }
    if (block.size() < 4096 && i + 1 < steps) continue;
    report.hits += queries.count_hits(block);
    block.clear();
  }
  report.steps = steps;
  report.renormalised = turning.renormalised();
  report.largest_deviation = turning.largest_deviation();
  return report;
}

}  // namespace graze::stress
