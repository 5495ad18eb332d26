#pragma once

#include <graze/engine/compare/fcl_motion.h>
#include <graze/engine/compare/peers/engine.h>

#include <span>
#include <vector>

namespace graze::compare {

/// Shapes as FCL holds them for questions about motions; of a pair of meshes A is the first. What
/// FCL needs is built for the first such question. One thread at a time may ask.
class FclMotions {
 public:
  FclMotions(std::span<const Shape> shapes, const FclMotionSettings& settings)
      : shapes_(shapes.begin(), shapes.end()), settings_(settings) {}

  /// Of Ask::FirstContact and Free, without a clearance, which FCL does not know here. One time is
  /// all that it says of a contact.
  std::optional<CaseAnswer> answer(const Question& question, const PlacedShape& a,
                                   const PlacedShape& b) const;

 private:
  std::vector<Shape> shapes_;
  mutable std::vector<FclMover> movers_;
  FclMotionSettings settings_;
};

}  // namespace graze::compare
