#include <graze/engine/mesh/data/vertex_fans.h>
#include <graze/engine/mesh/pairs/corner_labels.h>
#include <graze/narrowphase/triangle_pair/vertex_fan.h>
#include <hwy/cache_control.h>

#include <limits>
#include <span>

namespace graze {
namespace {

using Corners = std::array<std::uint32_t, 3>;
using narrowphase::VertexFan;

/// The triangles around a welded vertex, by where they come from and lead to, and in their order
/// around it, if they have one.
class VertexRing {
 public:
  /// Gathers the triangles around one vertex, which have these welded corners. Returns false if
  /// there are too many.
  bool gather(std::uint32_t vertex, std::span<const std::uint32_t> triangles,
              const std::vector<Corners>& corners) {
    size_ = triangles.size();
    if (size_ >= VertexFan::kMostRays) return false;
    for (std::size_t i = 0; i < size_; ++i) {
      const Corners& c = corners[triangles[i]];
      const int at = c[0] == vertex ? 0 : (c[1] == vertex ? 1 : 2);
      from_[i] = c[(at + 1) % 3];
      to_[i] = c[(at + 2) % 3];
    }
    return true;
  }

  /// Sorts the triangles so that each begins where the one before ends. Returns false if that
  /// cannot be done with all of them, each once.
  bool sort() {
    if (follow(0)) return true;
    if (kind_ == VertexFan::Kind::Closed) return false;
    for (std::size_t i = 0; i < size_; ++i) {
      if (find(to_, from_[i]) == size_) return follow(i);
    }
    return false;
  }

  VertexFan::Kind kind() const { return kind_; }
  /// Returns the vertices that the rays lead to.
  std::span<const std::uint32_t> rays() const { return {rays_, ray_count_}; }

 private:
  std::size_t find(const std::uint32_t* in, std::uint32_t vertex) const {
    std::size_t i = 0;
    while (i < size_ && in[i] != vertex)
      ++i;
    return i;
  }

  /// Follows the triangles from the first to the one that comes back to it, or to the last. Where
  /// several begin with one vertex the way may never come back and meet some of them again; but no
  /// fan with a ray twice is simple.
  bool follow(std::size_t first) {
    ray_count_ = 0;
    kind_ = VertexFan::Kind::Open;
    rays_[ray_count_++] = from_[first];
    std::size_t last = first;
    for (std::size_t n = 1; n < size_; ++n) {
      const std::size_t next = find(from_, to_[last]);
      if (next == size_) return false;
      if (next == first) {
        kind_ = VertexFan::Kind::Closed;
        return false;
      }
      rays_[ray_count_++] = to_[last];
      last = next;
    }
    if (to_[last] == from_[first])
      kind_ = VertexFan::Kind::Closed;
    else
      rays_[ray_count_++] = to_[last];
    return true;
  }

  std::uint32_t from_[VertexFan::kMostRays];
  std::uint32_t to_[VertexFan::kMostRays];
  std::uint32_t rays_[VertexFan::kMostRays];
  std::size_t size_ = 0;
  std::size_t ray_count_ = 0;
  VertexFan::Kind kind_ = VertexFan::Kind::Open;
};

/// Tells whether the triangles around a vertex surely have no more in common than that and their
/// edges.
class SureVertices {
 public:
  SureVertices(const Mesh& mesh, const std::vector<Corners>& corners)
      : vertices_(mesh.vertices()),
        corners_(corners),
        fans_(fans_of(mesh.triangles(), mesh.welded())) {}

  bool is_sure(std::uint32_t vertex) {
    prefetch(fans_.first[vertex] + kFetched);
    const std::span<const std::uint32_t> around = fans_.around(vertex);
    if (around.empty() || !ring_.gather(vertex, around, corners_) || !ring_.sort()) return false;
    const Eigen::Vector3d* rays[VertexFan::kMostRays];
    const std::span<const std::uint32_t> to = ring_.rays();
    for (std::size_t i = 0; i < to.size(); ++i)
      rays[i] = &vertices_[to[i]];
    return narrowphase::is_surely_simple({&vertices_[vertex], {rays, to.size()}, ring_.kind()});
  }

 private:
  /// The number of triangles that are fetched ahead: a few vertices, which takes as long as memory
  /// does.
  static constexpr std::uint32_t kFetched = 32;

  void prefetch(std::uint32_t first) const {
    for (std::uint32_t i = first; i < first + 6 && i < fans_.triangles.size(); ++i)
      hwy::Prefetch(&corners_[fans_.triangles[i]]);
  }

  std::span<const Eigen::Vector3d> vertices_;
  const std::vector<Corners>& corners_;
  VertexFans fans_;
  VertexRing ring_;
};

}  // namespace

std::vector<Corners> corner_labels(const Mesh& mesh) {
  const std::span<const TriangleIndices> triangles = mesh.triangles();
  const std::span<const std::uint32_t> welded = mesh.welded();
  std::vector<Corners> labels(triangles.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (int k = 0; k < 3; ++k)
      labels[i][k] = welded[triangles[i][k]];
  }
  // A corner whose vertex is not sure has a number that is no vertex and no other corner's.
  const std::size_t corners = 3 * labels.size();
  const bool are_numbers_left = welded.size() + corners < std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint8_t> is_sure(welded.size());
  if (are_numbers_left) {
    SureVertices sure(mesh, labels);
    for (std::uint32_t vertex = 0; vertex < is_sure.size(); ++vertex)
      is_sure[vertex] = sure.is_sure(vertex);
  }
  auto number = std::numeric_limits<std::uint32_t>::max();
  for (Corners& triangle : labels) {
    for (std::uint32_t& label : triangle) {
      if (is_sure[label] == 0) label = number--;
    }
  }
  return labels;
}

}  // namespace graze
