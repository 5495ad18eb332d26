#pragma once

#include <graze/engine/compare/fcl_motion.h>
#include <graze/engine/compare/peers/engine.h>

#include <span>
#include <vector>

namespace graze::compare {

/// Holds shapes as FCL does for questions about motions; of a pair of meshes A is the first. What
/// FCL needs is built for the first such question. One thread may ask at a time.
class FclMotions {
 public:
  FclMotions(std::span<const Shape> shapes, const FclMotionSettings& settings)
      : shapes_(shapes.begin(), shapes.end()), settings_(settings) {}

  /// Answers Ask::FirstContact and Free, without a clearance, which FCL does not know here. One
  /// time is all that FCL says of a contact.
  std::optional<CaseAnswer> answer(const Question& question, const PlacedShape& a,
                                   const PlacedShape& b) const;

 private:
  std::vector<Shape> shapes_;
  mutable std::vector<FclMover> movers_;
  FclMotionSettings settings_;
};

}  // namespace graze::compare
