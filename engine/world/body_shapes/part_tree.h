#pragma once

// A tree over the parts of a compound, in its own frame. Private to engine/world.

#include <graze/engine/world/body_shapes/gap_to_parts.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace graze {

/// A tree that knows parts by their places in the list of boxes that it is made of.
class PartTree {
 public:
  /// Builds the tree. It costs O(n log n), and up to 60 bytes for each box.
  explicit PartTree(const std::vector<Aabb>& boxes);

  /// A function that is called with the place of a part, and returns how far to look from then on,
  /// metres.
  using Look = std::function<double(std::uint32_t)>;

  /// Calls `look` for all parts that may be no farther than the limit, nearer branches first, but
  /// not for those in branches that, with room around them, are apart from the box `within`. The
  /// distance of a branch is first bounded by its box, and then by the measured gap to that box.
  void look_at_nearest(const std::optional<Aabb>& within, double room, const GapToParts& gap,
                       double limit, const Look& look) const;

 private:
  struct Node {
    Aabb box;
    std::uint32_t first = 0;  ///< the first of its parts in `places_`
    std::uint32_t count = 0;
    std::uint32_t second = 0;  ///< the second branch, as the first one follows this node; 0 for a
                               ///< leaf
  };
  struct Search;

  std::uint32_t build(const std::vector<Aabb>& boxes, std::uint32_t first, std::uint32_t count);
  double look_in(const Search& search, std::uint32_t node, double limit) const;

  std::vector<std::uint32_t> places_;
  std::vector<Node> nodes_;
};

}  // namespace graze
