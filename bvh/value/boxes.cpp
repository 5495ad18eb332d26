#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/boxes.h>
#include <graze/bvh/value/parallel.h>
#include <graze/bvh/value/point_pairs.h>

#include <bit>
#include <cmath>
#include <string>

namespace graze::bvh {
namespace {

/// The number of boxes that one task looks at.
constexpr std::size_t kGrain = 8192;

/// The box around those that were looked at, and whether each had its minimum below its maximum,
/// which NaN has not.
struct Seen {
  PointPairs min;
  PointPairs max;
  PairMask is_ordered = {-1, -1};

  explicit Seen(const Aabb& box)
      : min(load_point(box.min.data())), max(load_point(box.max.data())) {}

  void add(const Aabb& box) {
    const PointPairs low = load_point(box.min.data());
    const PointPairs high = load_point(box.max.data());
    is_ordered &= (low.xy <= high.xy) & (low.yz <= high.yz);
    min = smaller(min, low);
    max = larger(max, high);
  }

  void add(const Seen& other) {
    is_ordered &= other.is_ordered;
    min = smaller(min, other.min);
    max = larger(max, other.max);
  }

  /// Returns the box around all. Adding zero makes both zeros one: which of them was met first is a
  /// matter of chance.
  Aabb box() const {
    return {{min.xy[0] + 0.0, min.xy[1] + 0.0, min.yz[1] + 0.0},
            {max.xy[0] + 0.0, max.xy[1] + 0.0, max.yz[1] + 0.0}};
  }

  /// True if each box was valid. A box that is infinite but ordered makes the box around all
  /// infinite.
  bool is_valid() const {
    const Aabb all = box();
    bool is_finite = true;
    for (int k = 0; k < 3; ++k)
      is_finite &= std::isfinite(all.min.data()[k]) && std::isfinite(all.max.data()[k]);
    return is_finite && (is_ordered[0] & is_ordered[1]) != 0;
  }
};

void name_invalid(std::span<const Aabb> boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    try {
      check_box(boxes[i], "box");
    } catch (const InputError& error) {
      throw InputError("tree: box " + std::to_string(i) + ": " + error.what(),
                       {.element = "box", .index = i});
    }
  }
}

}  // namespace

Aabb checked_bounds(std::span<const Aabb> boxes) {
  if (boxes.empty()) throw InputError("tree: no boxes");
  if (boxes.size() > 0x7fffffff) throw InputError("tree: more than 2^31 - 1 boxes");
  const Seen all = reduce_in_parallel(
      tbb::blocked_range<std::size_t>(0, boxes.size(), kGrain), Seen(boxes[0]),
      [&](const tbb::blocked_range<std::size_t>& range, Seen seen) {
        return in_standard_arithmetic([&] {
          for (std::size_t i = range.begin(); i < range.end(); ++i)
            seen.add(boxes[i]);
          return seen;
        });
      },
      [](Seen a, const Seen& b) {
        return in_standard_arithmetic([&] {
          a.add(b);
          return a;
        });
      });
  if (!all.is_valid()) name_invalid(boxes);
  return all.box();
}

}  // namespace graze::bvh
