#include <graze/bvh/build/build.h>
#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/motion/mesh_path_data.h>

#include <algorithm>
#include <string>
#include <tuple>

namespace graze {
namespace {

void check_same_triangles(const Mesh& start, const Mesh& end) {
  if (start.vertices().size() != end.vertices().size()) {
    throw MeshError("path: " + std::to_string(start.vertices().size()) +
                    " vertices at the start and " + std::to_string(end.vertices().size()) +
                    " at the end");
  }
  const auto of_start = start.triangles(), of_end = end.triangles();
  if (of_start.size() != of_end.size()) {
    throw MeshError("path: " + std::to_string(of_start.size()) + " triangles at the start and " +
                    std::to_string(of_end.size()) + " at the end");
  }
  if (of_start.data() == of_end.data()) return;
  const auto differs = std::mismatch(of_start.begin(), of_start.end(), of_end.begin()).first;
  if (differs == of_start.end()) return;
  const auto index = static_cast<std::size_t>(differs - of_start.begin());
  throw MeshError("path: triangle " + std::to_string(index) + " is another one at the end",
                  {.element = "triangle", .index = index});
}

Aabb around(const Aabb& a, const Triangle& t) {
  Aabb box = a;
  for (const Eigen::Vector3d* p : {&t.a, &t.b, &t.c}) {
    for (int k = 0; k < 3; ++k) {
      box.min.data()[k] = std::min(box.min.data()[k], p->data()[k]);
      box.max.data()[k] = std::max(box.max.data()[k], p->data()[k]);
    }
  }
  return box;
}

struct EdgeUse {
  std::uint32_t low;  ///< the vertices of the edge, by their indices
  std::uint32_t high;
  std::uint32_t triangle;
  std::uint32_t place;

  auto operator<=>(const EdgeUse&) const = default;
};

std::vector<std::uint8_t> represented_features(const Mesh& mesh) {
  const auto triangles = mesh.triangles();
  std::vector<std::uint8_t> represented(triangles.size());
  std::vector<bool> is_represented(mesh.vertices().size());
  std::vector<EdgeUse> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = triangles[t][k], next = triangles[t][(k + 1) % 3];
      if (!is_represented[vertex]) represented[t] |= corner_bit(k);
      is_represented[vertex] = true;
      edges.push_back({std::min(vertex, next), std::max(vertex, next), t, k});
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i > 0 && edges[i].low == edges[i - 1].low && edges[i].high == edges[i - 1].high) continue;
    represented[edges[i].triangle] |= edge_bit(edges[i].place);
  }
  return represented;
}

}  // namespace

MeshPath::MeshPath(const Mesh& start, const Mesh& end) {
  data_ = bvh::in_standard_arithmetic([&]() -> std::shared_ptr<const Data> {
    check_same_triangles(start, end);
    const std::size_t count = start.triangles().size();
    std::vector<Aabb> boxes(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Triangle t = start.triangle(i);
      boxes[i] = around(around({t.a, t.a}, t), end.triangle(i));
    }
    Aabb bounds = boxes[0];
    for (const Aabb& box : boxes)
      bounds = around(bounds, {box.min, box.max, box.max});
    return std::make_shared<const Data>(
        Data{start, end, bvh::build(boxes), bounds, represented_features(start)});
  });
}

const Mesh& MeshPath::start() const {
  return data_->start;
}

const Mesh& MeshPath::end() const {
  return data_->end;
}

std::size_t MeshPath::bytes() const {
  return sizeof(Data) + data_->tree.nodes.capacity() * sizeof(bvh::Node) +
         data_->tree.primitives.capacity() * sizeof(std::uint32_t) + data_->represented.capacity();
}

}  // namespace graze
