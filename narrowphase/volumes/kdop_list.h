#pragma once

#include <graze/bvh/kdop.h>
#include <graze/narrowphase/volumes/volume_rows.h>
#include <cstddef>
#include <cstdint>
#include <span>

namespace graze {

/// Valid k-DOPs, stored slab by slab for tests of many at once.
class KDopList {
 public:
  std::size_t size() const { return rows_.size(); }

  /// Returns the k-DOP at `index`, which is below size().
  KDop<18> operator[](std::size_t index) const;

  /// Throws InputError, which names the index that the k-DOP would have had, for a bad one.
  /// Amortised constant time.
  void add(const KDop<18>& kdop);

  void clear() { rows_.clear(); }

 private:
  friend void intersects(const KDop<18>& kdop, const KDopList& kdops, std::span<std::uint8_t> hits);
  friend void intersects(const KDopList& kdops_a, const KDopList& kdops_b,
                         std::span<std::uint8_t> hits);

  narrowphase::VolumeRows<18> rows_;  ///< nine minima, nine maxima
};

// These functions make many tests at once, as in aabb_list.h; the answers are those of intersects()
// for two k-DOPs.

/// Tests one k-DOP against each of many.
void intersects(const KDop<18>& kdop, const KDopList& kdops, std::span<std::uint8_t> hits);

/// Tests pairs: element i of one list against element i of the other.
void intersects(const KDopList& kdops_a, const KDopList& kdops_b, std::span<std::uint8_t> hits);

}  // namespace graze
