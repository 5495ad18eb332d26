#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/lanes.h>
#include <graze/bvh/value/local_frame.h>
#include <graze/bvh/value/parallel.h>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace graze::bvh {

/// A primitive on its way into a tree: its local box, with its index in the fourth lane of
/// minus_min. 32 bytes, which partitions move about as two registers.
struct Reference {
  Bounds box;

  std::uint32_t index() const {
    return static_cast<std::uint32_t>(std::bit_cast<IntLanes>(box.minus_min)[3]);
  }
};
static_assert(sizeof(Reference) == 32);

static inline Reference reference_to(const Bounds& box, std::uint32_t index) {
  IntLanes bits = std::bit_cast<IntLanes>(box.minus_min);
  bits[3] = static_cast<std::int32_t>(index);
  Lanes max = box.max;
  max[3] = 0;
  return {{std::bit_cast<Lanes>(bits), max}};
}

/// References that are about to be written, so that no time is spent on clearing them.
struct References {
  std::unique_ptr<Reference[]> data;
  std::size_t size = 0;

  References() = default;
  explicit References(std::size_t count)
      : data(std::make_unique_for_overwrite<Reference[]>(count)), size(count) {}
  std::span<Reference> all() { return {data.get(), size}; }
};

/// Makes references to `count` primitives, whose local box `box_of(i)` says, in parallel.
template <typename BoxOf>
References references_made(std::size_t count, const BoxOf& box_of) {
  References references(count);
  constexpr std::size_t kGrain = 4096;
  for_in_parallel(tbb::blocked_range<std::size_t>(0, count, kGrain),
                  [&](const tbb::blocked_range<std::size_t>& range) {
                    in_standard_arithmetic([&] {
                      for (std::size_t i = range.begin(); i < range.end(); ++i)
                        references.data[i] = reference_to(box_of(i), static_cast<std::uint32_t>(i));
                    });
                  });
  return references;
}

/// Makes references to these primitives, in this order, in parallel.
template <typename BoxOf>
References references_made(std::span<const std::uint32_t> primitives, const BoxOf& box_of) {
  References references(primitives.size());
  constexpr std::size_t kGrain = 4096;
  for_in_parallel(tbb::blocked_range<std::size_t>(0, primitives.size(), kGrain),
                  [&](const tbb::blocked_range<std::size_t>& range) {
                    in_standard_arithmetic([&] {
                      for (std::size_t i = range.begin(); i < range.end(); ++i)
                        references.data[i] = reference_to(box_of(primitives[i]), primitives[i]);
                    });
                  });
  return references;
}

/// Makes references to all boxes, in their order, rounded outward in the frame, in parallel.
References references_to(std::span<const Aabb> boxes, const LocalFrame& frame);

/// Makes references to the boxes of these primitives, in this order.
References references_to(std::span<const Aabb> boxes, const LocalFrame& frame,
                         std::span<const std::uint32_t> primitives);

}  // namespace graze::bvh
