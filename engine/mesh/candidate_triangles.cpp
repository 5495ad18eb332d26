#include <graze/engine/mesh/candidate_triangles.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/coordinates.h>
#include <graze/narrowphase/triangle_pair_batch.h>

namespace graze {
namespace {

using Rows = double[9][CandidateTriangles::kBlock];

void set_lane(Rows& rows, std::size_t lane, const Triangle& triangle) {
  const double* values = narrowphase::coordinates(triangle);
  for (int row = 0; row < 9; ++row)
    rows[row][lane] = values[row];
}

Triangle lane_of(const Rows& rows, std::size_t lane) {
  return {{rows[0][lane], rows[1][lane], rows[2][lane]},
          {rows[3][lane], rows[4][lane], rows[5][lane]},
          {rows[6][lane], rows[7][lane], rows[8][lane]}};
}

void copy_lane(const Rows& from, std::size_t from_lane, Rows& to, std::size_t lane) {
  for (int row = 0; row < 9; ++row)
    to[row][lane] = from[row][from_lane];
}

narrowphase::TriangleRows view_of(const Rows& rows) {
  narrowphase::TriangleRows view{};
  for (std::size_t row = 0; row < 9; ++row)
    view.row[row] = rows[row];
  view.size = CandidateTriangles::kBlock;
  return view;
}

}  // namespace

void CandidateTriangles::clear() {
  pairs_.clear();
  blocks_.clear();
}

void CandidateTriangles::add(TrianglePair pair, const Triangle& a, const Triangle& b) {
  const std::size_t lane = pairs_.size() % kBlock;
  // Zero, so that lanes that hold no pair can be computed with.
  if (lane == 0) blocks_.push_back({});
  pairs_.push_back(pair);
  Block& block = blocks_.back();
  set_lane(block.a, lane, a);
  set_lane(block.placed_a, lane, place(pose_a_, a));
  set_lane(block.b, lane, b);
}

void CandidateTriangles::drop(std::size_t index) {
  const std::size_t last = pairs_.size() - 1;
  if (index != last) {
    const Block& from = blocks_.back();
    Block& to = blocks_[index / kBlock];
    copy_lane(from.a, last % kBlock, to.a, index % kBlock);
    copy_lane(from.placed_a, last % kBlock, to.placed_a, index % kBlock);
    copy_lane(from.b, last % kBlock, to.b, index % kBlock);
    pairs_[index] = pairs_.back();
  }
  pairs_.pop_back();
  if (last % kBlock == 0) blocks_.pop_back();
}

void CandidateTriangles::place_a(const Pose& pose) {
  pose_a_ = pose;
  for (Block& block : blocks_)
    place_rows(pose, block.a, block.placed_a);
}

/// Law 1, as place() has it.
void CandidateTriangles::place_rows(const Pose& pose, const Rows& rows, Rows& placed) {
  const double* m = pose.data();  // column-major 4x4
  for (std::size_t corner = 0; corner < 9; corner += 3) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = m[i], y = m[4 + i], z = m[8 + i], t = m[12 + i];
      for (std::size_t lane = 0; lane < kBlock; ++lane) {
        placed[corner + i][lane] =
            ((x * rows[corner][lane] + y * rows[corner + 1][lane]) + z * rows[corner + 2][lane]) +
            t;
      }
    }
  }
}

CandidateTriangles::Placed::Placed(const CandidateTriangles& all, std::size_t block,
                                   const Pose& pose_b)
    : a_(all.blocks_[block].placed_a) {
  place_rows(pose_b, all.blocks_[block].b, b_);
}

narrowphase::Verdicts CandidateTriangles::Placed::verdicts() const {
  narrowphase::Verdicts verdicts;
  narrowphase::triage(view_of(a_), view_of(b_), &verdicts);
  return verdicts;
}

Triangle CandidateTriangles::Placed::a(std::size_t lane) const {
  return lane_of(a_, lane);
}

Triangle CandidateTriangles::Placed::b(std::size_t lane) const {
  return lane_of(b_, lane);
}

}  // namespace graze
