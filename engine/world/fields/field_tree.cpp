#include <graze/bvh/value/float_box.h>
#include <graze/bvh/value/local_frame.h>
#include <graze/bvh/value/to_local.h>
#include <graze/engine/world/fields/field_tree.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace graze {

namespace {

/// A cell by its first triangle in the patch; its other triangle is the next one.
struct Cell {
  std::uint32_t triangle;
  bvh::FloatBox box;
};

class RectTree {
 public:
  RectTree(const HeightFieldData& field, const CellRect& rect, const MeshPatch& patch)
      : patch_(patch),
        columns_(rect.last_column - rect.first_column),
        frame_(bvh::LocalFrame::around(patch.bounds)),
        to_local_(frame_) {
    tree_.frame = frame_;
    first_.assign(static_cast<std::size_t>(rect.count()), kHole);
    std::uint32_t next = 0;
    for (std::size_t cell = 0; cell < first_.size() && next < patch.triangles.size(); ++cell) {
      const auto column = static_cast<std::uint32_t>(cell % columns_);
      const auto row = static_cast<std::uint32_t>(cell / columns_);
      const std::uint32_t number =
          field.triangle_number(rect.first_column + column, rect.first_row + row);
      if (patch.triangle_numbers[next] == number) first_[cell] = next, next += 2;
    }
    cells_.clear();
    order({0, 0, columns_, rect.last_row - rect.first_row});
  }

  bvh::Tree made() {
    tree_.nodes.reserve(cells_.size() + 1);
    tree_.primitives.reserve(2 * cells_.size());
    tree_.nodes.resize(1);
    fill(0, 0, cells_.size());
    return std::move(tree_);
  }

 private:
  static constexpr std::uint32_t kHole = 0xffffffffu;
  static constexpr std::size_t kCellsOfLeaf = 2;

  /// Memory that is kept from one tree to the next.
  struct Scratch {
    std::vector<std::uint32_t> first;
    std::vector<Cell> cells;
  };
  static Scratch& scratch() {
    static thread_local Scratch kept;  // no tree is made within another
    return kept;
  }

  /// Lists the cells so that those of a half follow each other.
  void order(const CellRect& rect) {
    const std::uint32_t columns = rect.last_column - rect.first_column;
    const std::uint32_t rows = rect.last_row - rect.first_row;
    if (columns == 1 && rows == 1) {
      const std::uint32_t first =
          first_[std::size_t{rect.first_row} * columns_ + rect.first_column];
      if (first != kHole) cells_.push_back({first, box_of(first)});
      return;
    }
    CellRect low = rect, high = rect;
    if (columns >= rows) {
      low.last_column = high.first_column = rect.first_column + columns / 2;
    } else {
      low.last_row = high.first_row = rect.first_row + rows / 2;
    }
    order(low);
    order(high);
  }

  bvh::FloatBox box_of(std::uint32_t triangle) const {
    const TriangleIndices& low = patch_.triangles[triangle];
    const TriangleIndices& high = patch_.triangles[triangle + 1];
    Aabb box{patch_.vertices[low[0]], patch_.vertices[low[0]]};
    for (const std::uint32_t vertex : {low[1], low[2], high[2]}) {
      const Eigen::Vector3d& p = patch_.vertices[vertex];
      for (int k = 0; k < 3; ++k) {
        box.min.data()[k] = std::min(box.min.data()[k], p.data()[k]);
        box.max.data()[k] = std::max(box.max.data()[k], p.data()[k]);
      }
    }
    const bvh::Bounds bounds = to_local_.box(box.min.data(), box.max.data());
    bvh::FloatBox local{};
    for (int k = 0; k < 3; ++k) {
      local.min[k] = -bounds.minus_min[k];
      local.max[k] = bounds.max[k];
    }
    return local;
  }

  void fill(std::size_t node, std::size_t first, std::size_t last) {
    if (last - first <= kCellsOfLeaf) {
      bvh::Node leaf{bvh::empty_box(), static_cast<std::uint32_t>(tree_.primitives.size()),
                     static_cast<std::uint32_t>(2 * (last - first))};
      for (std::size_t i = first; i < last; ++i) {
        leaf.box = bvh::merged(leaf.box, cells_[i].box);
        tree_.primitives.push_back(cells_[i].triangle);
        tree_.primitives.push_back(cells_[i].triangle + 1);
      }
      tree_.nodes[node] = leaf;
      return;
    }
    const std::size_t children = tree_.nodes.size();
    tree_.nodes.resize(children + 2);
    const std::size_t middle = first + (last - first) / 2;
    fill(children, first, middle);
    fill(children + 1, middle, last);
    tree_.nodes[node] = {bvh::merged(tree_.nodes[children].box, tree_.nodes[children + 1].box),
                         static_cast<std::uint32_t>(children), 0};
  }

  const MeshPatch& patch_;
  std::uint32_t columns_;
  bvh::LocalFrame frame_;
  bvh::ToLocal to_local_;
  std::vector<std::uint32_t>& first_ = scratch().first;
  std::vector<Cell>& cells_ = scratch().cells;
  bvh::Tree tree_;
};

}  // namespace

bvh::Tree tree_over(const HeightFieldData& field, const CellRect& rect, const MeshPatch& patch) {
  return RectTree(field, rect, patch).made();
}

}  // namespace graze
