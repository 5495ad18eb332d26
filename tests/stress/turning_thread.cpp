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

// A query of the whole nut takes milliseconds, too much for a million. A prime number of pieces, so
// that each piece comes round at all angles, and at those at which the whole nut is asked about.
constexpr std::size_t kPieces = 29;
constexpr std::size_t kWholeEvery = 100;

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

/// The mesh cut like a cake around the z axis, triangles whole: each is in one piece.
std::vector<Mesh> pieces_of(const Mesh& mesh, std::size_t count) {
  std::vector<std::vector<TriangleIndices>> triangles(count);
  for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
    const Triangle t = mesh.triangle(i);
    const Eigen::Vector3d sum = t.a + t.b + t.c;
    const double turn = 0.5 + std::atan2(sum.y(), sum.x()) / (2 * std::numbers::pi);
    const auto piece = static_cast<std::size_t>(turn * static_cast<double>(count));
    triangles[std::min(piece, count - 1)].push_back(mesh.triangles()[i]);
  }
  const std::vector<Eigen::Vector3d> vertices(mesh.vertices().begin(), mesh.vertices().end());
  std::vector<Mesh> pieces;
  for (const std::vector<TriangleIndices>& piece : triangles)
    pieces.emplace_back(vertices, piece);
  return pieces;
}

/// Queries of poses that come in blocks, by all processors: of one piece of the nut at each step,
/// the next one at the next, and of the whole nut now and then.
class ParallelQueries {
 public:
  ParallelQueries(const Mesh& bolt, const Mesh& nut)
      : bolt_(bolt), nut_(nut), pieces_(pieces_of(nut, kPieces)) {}

  static bool is_whole(std::size_t step) { return step % kWholeEvery == 0; }

  /// `poses` are those of the steps from `first` on.
  std::size_t count_hits(std::size_t first, const std::vector<Pose>& poses) const {
    std::atomic<std::size_t> next = 0;
    std::atomic<std::size_t> hits = 0;
    const auto work = [&] {
      for (std::size_t i = next++; i < poses.size(); i = next++) {
        const std::size_t step = first + i;
        const Mesh& nut = is_whole(step) ? nut_ : pieces_[step % kPieces];
        hits += intersects({bolt_}, {nut, poses[i]}, {.volume = PairVolume::Obb});
      }
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
  std::vector<Mesh> pieces_;
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
    report.whole += ParallelQueries::is_whole(i);
    if (i % between == between / 2) {
      Pose shifted = block.back();
      shifted.translation().z() += kPitch / 8;
      report.spot_wrong += !is_right(bolt, nut, block.back());
      report.shifted_wrong += !is_right(bolt, nut, shifted) || !intersects({bolt}, {nut, shifted});
      ++report.spot_checks;
    }
    if (block.size() < 4096 && i + 1 < steps) continue;
    report.hits += queries.count_hits(i + 1 - block.size(), block);
    block.clear();
  }
  report.steps = steps;
  report.renormalised = turning.renormalised();
  report.largest_deviation = turning.largest_deviation();
  return report;
}

}  // namespace graze::stress
