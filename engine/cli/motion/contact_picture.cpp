#include <graze/engine/cases/case.h>
#include <graze/engine/cli/motion/contact_picture.h>
#include <graze/engine/cli/outlines/case_outlines.h>
#include <graze/engine/cli/outlines/svg_picture.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/placement.h>

#include <algorithm>
#include <numeric>
#include <string_view>
#include <vector>

namespace graze::cli {
namespace {

/// Returns the triangles that are drawn, by how near their middles are to a point: as few as a
/// picture shows.
std::vector<std::uint32_t> triangles_near(const PlacedMeshView& placed,
                                          const Eigen::Vector3d& point) {
  const std::size_t count = placed.mesh.triangles().size();
  std::vector<double> away(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Triangle t = place(placed.pose, placed.mesh.triangle(i));
    away[i] = ((t.a - point) + (t.b - point) + (t.c - point)).squaredNorm();
  }
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  const std::size_t drawn = std::min(count, kMostTrianglesDrawn);
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(drawn), order.end(),
                    [&](std::uint32_t s, std::uint32_t t) {
                      return away[s] != away[t] ? away[s] < away[t] : s < t;
                    });
  order.resize(drawn);
  return order;
}

CaseMesh part_of(const PlacedMeshView& placed, const std::vector<std::uint32_t>& indices) {
  std::vector<TriangleIndices> triangles;
  triangles.reserve(indices.size());
  for (const std::uint32_t index : indices)
    triangles.push_back(placed.mesh.triangles()[index]);
  return {Mesh(placed.mesh.vertices(), triangles), placed.pose};
}

}  // namespace

std::string contact_picture(const PlacedMeshView& a, const PlacedMeshView& b) {
  const MeshDistance nearest = distance(a, b);
  const Eigen::Vector3d point = nearest.point_a / 2 + nearest.point_b / 2;
  std::vector<std::uint32_t> of_a = triangles_near(a, point), of_b = triangles_near(b, point);
  // The first triangle of A and the last of B, those that meet, say from where the picture is seen.
  std::erase(of_a, nearest.pair.a), std::erase(of_b, nearest.pair.b);
  of_a.insert(of_a.begin(), nearest.pair.a);
  of_b.resize(std::min(of_b.size(), kMostTrianglesDrawn - 1));
  std::reverse(of_b.begin(), of_b.end());
  of_b.push_back(nearest.pair.b);
  const Case drawn{.note = {},
                   .ask = Ask::Any,
                   .settings = {},
                   .a = part_of(a, of_a),
                   .b = part_of(b, of_b),
                   .answer = {},
                   .answered_by = {}};
  const std::string picture = svg_picture(drawn);
  constexpr std::string_view kOpening = "<svg ";
  if (!picture.starts_with(kOpening)) return "";
  const std::size_t end = picture.find('>') + 1;
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" " +
         picture.substr(kOpening.size(), end - kOpening.size()) +
         "<style>text { font: 11px sans-serif; } .bar { fill: none; stroke: #444; } "
         ".view { fill: #fafafa; stroke: #ccc; }</style>" +
         picture.substr(end) + "\n";
}

}  // namespace graze::cli
