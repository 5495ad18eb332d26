#pragma once

#include <graze/bvh/skins/float_volumes.h>
#include <graze/bvh/tree/box_separation.h>
#include <cstdint>
#include <span>

namespace graze::bvh {

/// Proves pairs of nodes apart by their spheres: squared distance of the centres against the square
/// of the sum of the radii (*Real-Time Rendering*, 16.13.1). An answer of true is sure; false is
/// not.
class SphereSeparation {
 public:
  SphereSeparation(const RelativeFrame& frame, std::span<const FloatSphere> skin_a,
                   std::span<const FloatSphere> skin_b)
      : frame_(frame), skin_a_(skin_a), skin_b_(skin_b) {}

  bool are_apart(std::uint32_t a, std::uint32_t b) const;
  bool is_first_larger(std::uint32_t a, std::uint32_t b) const;

 private:
  RelativeFrame frame_;
  std::span<const FloatSphere> skin_a_;
  std::span<const FloatSphere> skin_b_;
};

}  // namespace graze::bvh
