#include <graze/bvh/wide/tree/fit_slabs.h>
#include <graze/bvh/wide/tree/treelet_fit.h>

#include <algorithm>
#include <cmath>

namespace graze::bvh {
namespace {

/// Returns the corners leaf by leaf, with room for reading whole vectors at the end.
std::vector<float> leaf_blocks(std::span<const WideTopologyNode> nodes, const CornerRows& rows) {
  constexpr std::size_t kRoom = 4;
  std::vector<float> blocks(CornerRows::kRows * rows.size() + kRoom);
  for (const WideTopologyNode& node : nodes) {
    for (std::uint32_t j = 0; j < node.count; ++j) {
      if (!ChildLink::is_leaf(node.child[j])) continue;
      const PrimitiveRange range = node.range[j];
      float* block = blocks.data() + CornerRows::kRows * range.begin;
      for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t k = 0; k < 3; ++k)
          block = std::copy(rows.row(c, k) + range.begin, rows.row(c, k) + range.end, block);
      }
    }
  }
  return blocks;
}

/// Returns the sum of the areas, twice over, and of a share of the edges' squares, for lines have
/// no area. Every fourth primitive stands for its neighbours: what matters is how the sum changes.
double size_of(const CornerRows& rows) {
  constexpr float kOfEdges = 0x1p-8f;
  double sum = 0;
  for (std::size_t i = 0; i < rows.size(); i += 4) {
    float e[3], f[3];
    for (std::size_t k = 0; k < 3; ++k) {
      e[k] = rows.row(1, k)[i] - rows.row(0, k)[i];
      f[k] = rows.row(2, k)[i] - rows.row(0, k)[i];
    }
    const float x = e[1] * f[2] - e[2] * f[1];
    const float y = e[2] * f[0] - e[0] * f[2];
    const float z = e[0] * f[1] - e[1] * f[0];
    const float edges =
        (e[0] * e[0] + e[1] * e[1] + e[2] * e[2]) + (f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
    sum += 4 * (std::sqrt(x * x + y * y + z * z) + kOfEdges * edges);
  }
  return sum;
}

}  // namespace

float cost_of(double surfaces, const TreeletCorners& corners) {
  const double size = size_of(corners.rows);
  return size > 0 ? static_cast<float>(surfaces / size) : 0;
}

TreeletCorners::TreeletCorners(const TreeletPart& part, std::span<const std::uint32_t> order,
                               const LocalFrame& frame, const CornerSource& source)
    : rows(order.size()) {
  for (int k = 0; k < 3; ++k)
    origin[k] = 0.5 * part.box.min[k] + 0.5 * part.box.max[k];
  source.fill(order, frame, origin, rows);
}

void set_corners(Treelet& treelet, const TreeletPart& part, const TreeletCorners& corners,
                 std::span<const WideTopologyNode> topology) {
  std::copy_n(corners.origin, 3, treelet.origin);
  treelet.first = part.first;
  treelet.largest_coordinate = corners.rows.largest_coordinate();
  treelet.corners = leaf_blocks(topology, corners.rows);
}

float fit_nodes(Treelet& treelet, const TreeletCorners& corners,
                std::span<const WideTopologyNode> topology) {
  const MomentSums sums(corners.rows);
  double surfaces = 0;
  for (std::size_t i = 0; i < topology.size(); ++i) {
    surfaces +=
        fit_node(corners.rows, sums, ranges_of(topology[i]), corners.origin, treelet.nodes[i]);
  }
  choose_slabs(treelet.nodes);
  return cost_of(surfaces, corners);
}

}  // namespace graze::bvh
