#pragma once

// Private to engine/mesh.

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/pair.h>
#include <graze/narrowphase/triangle.h>
#include <graze/narrowphase/verdicts.h>

#include <cstddef>
#include <vector>

namespace graze {

/// Pairs of triangles that are decided again in pose after pose: eight side by side, coordinate by
/// coordinate, as they stand in their meshes, and A as it is placed.
class CandidateTriangles {
 public:
  std::size_t size() const { return pairs_.size(); }
  TrianglePair pair(std::size_t index) const { return pairs_[index]; }

  void clear();
  void add(TrianglePair pair, const Triangle& a, const Triangle& b);

  /// The last takes its place.
  void drop(std::size_t index);

  /// All from now on placed so.
  void place_a(const Pose& pose);

  /// Eight of them, B placed too: those from 8 `block` on.
  class Placed {
   public:
    Placed(const CandidateTriangles& all, std::size_t block, const Pose& pose_b);

    /// What triage() says of each: lanes that hold no pair may say anything.
    narrowphase::Verdicts verdicts() const;

    Triangle a(std::size_t lane) const;
    Triangle b(std::size_t lane) const;

   private:
    friend class CandidateTriangles;
    const double (&a_)[9][8];
    alignas(64) double b_[9][8];
  };

  static constexpr std::size_t kBlock = 8;

 private:
  /// Rows x, y, z of the corners.
  using Rows = double[9][kBlock];

  struct alignas(64) Block {
    Rows a;
    Rows placed_a;
    Rows b;
  };

  static void place_rows(const Pose& pose, const Rows& rows, Rows& placed);

  std::vector<TrianglePair> pairs_;
  std::vector<Block> blocks_;
  Pose pose_a_ = Pose::Identity();
};

}  // namespace graze
