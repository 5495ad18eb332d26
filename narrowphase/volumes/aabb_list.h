#pragma once

#include <graze/bvh/aabb.h>
#include <graze/narrowphase/volumes/sphere_arrays.h>
#include <graze/narrowphase/volumes/volume_rows.h>
#include <cstddef>
#include <cstdint>
#include <span>

namespace graze {

/// Valid axis-aligned boxes, stored coordinate by coordinate for tests of many at once.
class AabbList {
 public:
  std::size_t size() const { return rows_.size(); }

  /// Returns the box at `index`, which is below size().
  Aabb operator[](std::size_t index) const;

  /// Throws InputError, which names the index that the box would have had, for a bad box. Amortised
  /// constant time.
  void add(const Aabb& box);

  void clear() { rows_.clear(); }

  /// Returns a view for tests against spheres; the list must outlive it unchanged.
  AabbArray view() const;

 private:
  friend void intersects(const Aabb& box, const AabbList& boxes, std::span<std::uint8_t> hits);
  friend void intersects(const AabbList& boxes_a, const AabbList& boxes_b,
                         std::span<std::uint8_t> hits);

  narrowphase::VolumeRows<6> rows_;  ///< minimum x, y, z, maximum x, y, z
};

// These functions make many tests at once, a SIMD width at a time on whatever SIMD the CPU has:
// hits[i] becomes 1 or 0, what intersects() answers for element i alone, on every SIMD target.
// `hits` has the length of the list, which may be 0. They take linear time, allocate nothing, and
// throw InputError for lengths that differ and for a bad box.

/// Tests one box against each of many.
void intersects(const Aabb& box, const AabbList& boxes, std::span<std::uint8_t> hits);

/// Tests pairs: element i of one list against element i of the other.
void intersects(const AabbList& boxes_a, const AabbList& boxes_b, std::span<std::uint8_t> hits);

}  // namespace graze
