#pragma once

#include <graze/bvh/skins/float_volumes.h>
#include <graze/bvh/tree/box_separation.h>
#include <cstdint>
#include <span>

namespace graze::bvh {

/// Proves pairs of nodes apart by their oriented boxes: the separating axis test in the frame of
/// the box of A, at the price of two products of matrices. An answer of true is sure; false is not.
class ObbSeparation {
 public:
  ObbSeparation(const RelativeFrame& frame, std::span<const FloatObb> skin_a,
                std::span<const FloatObb> skin_b)
      : frame_(frame), skin_a_(skin_a), skin_b_(skin_b) {}

  bool are_apart(std::uint32_t a, std::uint32_t b) const;
  bool is_first_larger(std::uint32_t a, std::uint32_t b) const;

 private:
  RelativeFrame frame_;
  std::span<const FloatObb> skin_a_;
  std::span<const FloatObb> skin_b_;
};

}  // namespace graze::bvh
