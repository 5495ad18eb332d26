#pragma once

#include <graze/bvh/obb.h>
#include <graze/narrowphase/volumes/obb_rows.h>
#include <graze/narrowphase/volumes/volume_rows.h>
#include <cstddef>
#include <cstdint>
#include <span>

namespace graze {

/// Valid oriented boxes, stored number by number for tests of many at once.
class ObbList {
 public:
  std::size_t size() const { return rows_.size(); }

  /// Returns the box at `index`, which is below size().
  Obb operator[](std::size_t index) const;

  /// Throws InputError or PoseError, which names the index that the box would have had, for a bad
  /// box. Amortised constant time.
  void add(const Obb& box);

  void clear() { rows_.clear(); }

 private:
  friend void intersects(const Obb& box, const ObbList& boxes, std::span<std::uint8_t> hits);
  friend void intersects(const ObbList& boxes_a, const ObbList& boxes_b,
                         std::span<std::uint8_t> hits);

  narrowphase::VolumeRows<narrowphase::kObbRows> rows_;  ///< the rows in the order of
                                                         ///< narrowphase::ObbRow
};

// These functions make many tests at once, as in aabb_list.h; the answers are bit for bit those of
// intersects() for two oriented boxes, only "apart" being sure.

/// Tests one box against each of many.
void intersects(const Obb& box, const ObbList& boxes, std::span<std::uint8_t> hits);

/// Tests pairs: element i of one list against element i of the other.
void intersects(const ObbList& boxes_a, const ObbList& boxes_b, std::span<std::uint8_t> hits);

}  // namespace graze
