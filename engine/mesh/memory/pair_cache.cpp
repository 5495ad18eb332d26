// A gap that is proved in one pose, of the whole meshes or of a pair in a front, bounds the gap in
// later poses, too.
//
// In space: law 1 rounds a placed vertex by less than 7 u m + 2 u |t| in each coordinate, with m
// the mesh's largest and u = 2^-53, so that from one pose to another none moves by more than |dR x
// + dt| and 26 u m + 8 u |t|. With x = middle + y, |y| <= radius, that is |dR middle + dt| + radius
// |dR|, and the Frobenius norm is no less than the spectral one. The sums round by less than 54 u m
// + 12 u |t| more.
//
// In the frame of tree A, in common units, a point b of B lies at C b + T, and C, T are
// relative_frame()'s; where two placed triangles share a point, some points a, b of them have
// |C b + T - a| <= slack in each component, less than twice the slack in length. From C1, T1 to C2,
// T2 no b of the box m +- h moves by more than |dC m + dT| + sum h_j |dC_j|. So a gap less this
// motion that exceeds twice the new slack leaves no two triangles that meet.

#include <graze/engine/mesh/memory/pair_cache.h>
#include <graze/engine/mesh/placing/placement_check.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>

namespace graze {
namespace {

/// Lengths in the frame of A and in space differ by less: poses deviate by 1e-6 at most.
constexpr double kFrameGrowth = 1e-5;

/// Returns how far points of the box move between two placings, common units.
bvh::WideFront::MotionBound motion_of(const bvh::FloatBox& box, double unit,
                                      const double (&rotation)[3][3],
                                      const double (&translation)[3],
                                      const bvh::RelativeFrame& now) {
  double turns = 0;
  double moved[3] = {0, 0, 0};
  double sizes = 0;
  double total = 0;
  for (int j = 0; j < 3; ++j) {
    const double middle = (0.5 * box.min[j] + 0.5 * box.max[j]) * unit;
    const double half = (0.5 * box.max[j] - 0.5 * box.min[j]) * unit;
    double square = 0;
    for (int i = 0; i < 3; ++i) {
      const double turned = now.rotation[i][j] - rotation[i][j];
      moved[i] += turned * middle;
      square += turned * turned;
      sizes += std::abs(turned * middle);
    }
    total += half * std::sqrt(square);
    turns += square;
  }
  double square = 0;
  for (int i = 0; i < 3; ++i) {
    const double offset = now.translation[i] - translation[i];
    sizes += std::abs(offset);
    square += (moved[i] + offset) * (moved[i] + offset);
  }
  // These cover the rounding of sums of five terms, and squares that underflow.
  const double displacement =
      (std::sqrt(square) + total) * (1 + 0x1p-40) + 0x1p-48 * sizes + 0x1p-500;
  return {displacement, std::sqrt(turns) * (1 + 0x1p-40) + 0x1p-45};
}

}  // namespace

bool have_same_bits(const Pose& one, const Pose& other) {
  if (one.data()[12] != other.data()[12]) return false;  // poses that move differ here mostly
  std::uint64_t difference = 0;
  for (int i = 0; i < 16; ++i)
    difference |=
        std::bit_cast<std::uint64_t>(one.data()[i]) ^ std::bit_cast<std::uint64_t>(other.data()[i]);
  return difference == 0;
}

CachedMesh::CachedMesh(const Mesh& mesh) : mesh_(mesh), sizes_(sum_of_sizes(mesh.bounds())) {
  const double* low = mesh.bounds().min.data();
  const double* high = mesh.bounds().max.data();
  double square = 0;
  largest_ = 0;
  for (int k = 0; k < 3; ++k) {
    middle_[k] = 0.5 * low[k] + 0.5 * high[k];
    const double half = 0.5 * high[k] - 0.5 * low[k];
    square += half * half;
    largest_ = std::max(largest_, std::max(std::abs(low[k]), std::abs(high[k])));
  }
  radius_ = std::sqrt(square) * (1 + 0x1p-40) + 0x1p-48 * largest_ + 0x1p-500;
}

void CachedMesh::place(const Pose& pose, const char* what) {
  if (is_placed_ && have_same_bits(pose, pose_)) return;
  is_placed_ = false;
  error_ = bvh::RotationError(pose);
  if (!is_surely_placeable(pose, error_, sizes_)) check_placement(pose, mesh_.bounds(), what);
  pose_ = pose;
  ++pose_number_;
  is_placed_ = true;
}

CachedMesh::DisplacementBound CachedMesh::displacement_from(const Pose& before) const {
  const double* m = pose_.data();  // column-major 4x4
  const double* n = before.data();
  double moved[3];
  double turned_square = 0;
  double sizes = largest_;
  for (int i = 0; i < 3; ++i) {
    moved[i] = m[12 + i] - n[12 + i];
    sizes += std::abs(m[12 + i]) + std::abs(n[12 + i]);
    for (int j = 0; j < 3; ++j) {
      const double turned = m[4 * j + i] - n[4 * j + i];
      moved[i] += turned * middle_[j];
      turned_square += turned * turned;
    }
  }
  // The square of a sum is at most twice the sum of squares: this saves a root.
  const double square = moved[0] * moved[0] + moved[1] * moved[1] + moved[2] * moved[2];
  return {2 * (square + radius_ * radius_ * turned_square) * (1 + 0x1p-40),
          0x1p-46 * sizes + 0x1p-500};
}

void PairCache::place(const Pose& pose_a, const Pose& pose_b) {
  a_.place(pose_a, "pose of mesh A");
  b_.place(pose_b, "pose of mesh B");
  // The count is capped, as some queries take nanoseconds only.
  queries_ = std::min(queries_ + 1, kMostQueries);
}

bool PairCache::are_apart_by(double metres) const {
  if (!(gap_ > metres)) return false;
  const CachedMesh::DisplacementBound of_a = displacement_from(gap_pose_a_, a_);
  const CachedMesh::DisplacementBound of_b = displacement_from(gap_pose_b_, b_);
  const double left =
      gap_ - metres * (1 + 0x1p-40) - 0x1p-46 * gap_ - of_a.rounding - of_b.rounding;
  // If only one of the two moved, its motion is the sum.
  const double both = of_a.square + of_b.square;
  const double square = of_a.square > 0 && of_b.square > 0 ? 2 * both : both;
  return left > 0 && left * left * (1 - 0x1p-40) > square;
}

bool PairCache::are_still_apart_by(double metres, Work* work) {
  if (!are_apart_by(metres)) return false;
  ++still_apart;
  if (work != nullptr) ++work->skipped_by_memory;
  return true;
}

void PairCache::learn_gap(double metres) {
  if (!(metres > 0) || !std::isfinite(metres)) return;
  gap_ = metres;
  gap_pose_a_ = pose_of(a_);
  gap_pose_b_ = pose_of(b_);
}

bool PairCache::add_motion(const WideQuery& query) {
  const bvh::RelativeFrame& now = query.b_in_a;
  const bool was_known = is_motion_known_;
  if (was_known) {
    const bvh::WideFront::MotionBound step =
        motion_of(query.tree_b.box(), now.units_b, rotation_, translation_, now);
    intersection_front.add_motion(step, queries_);
    distance_front.add_motion(step, queries_);
  }
  for (int i = 0; i < 3; ++i) {
    std::copy_n(now.rotation[i], 3, rotation_[i]);
    translation_[i] = now.translation[i];
  }
  is_motion_known_ = true;
  queries_ = 0;
  return was_known;
}

void PairCache::remember(std::span<const TrianglePair> found) {
  pair_count_ = std::min(found.size(), kMostPairs);
  std::copy_n(found.begin(), pair_count_, pairs_.begin());
}

PairCache& recall(PairMemory& memory, const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b) {
  if (!memory.cache_ || !memory.cache_->is_about(mesh_a, mesh_b))
    memory.cache_ = std::make_unique<PairCache>(mesh_a.mesh, mesh_b.mesh);
  memory.cache_->place(mesh_a.pose, mesh_b.pose);
  return *memory.cache_;
}

double gap_of_bounds(const WideQuery& query) {
  const bvh::RelativeFrame& frame = query.b_in_a;
  const double gap = bvh::gap_along_faces(frame, query.tree_a.box(), query.tree_b.box());
  const double unit = std::max(query.frame_a.frame.unit(), query.frame_b.frame.unit());
  // Two slacks are for where placed triangles are (above), the others for how the gap is rounded.
  return (gap * (1 - kFrameGrowth) - 4 * frame.slack) * (1 - kFrameGrowth) * unit;
}

}  // namespace graze
