#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/to_local.h>
#include <graze/engine/mesh/data/mesh_data.h>
#include <graze/engine/work.h>
#include <tbb/task_arena.h>

#include <cmath>

namespace graze {
namespace {

/// Law 5's local coordinates of triangles' corners. The meshes' own data outlive it.
class MeshCorners : public bvh::CornerSource {
 public:
  MeshCorners(std::span<const Eigen::Vector3d> vertices, std::span<const TriangleIndices> triangles)
      : vertices_(vertices), triangles_(triangles) {}

  std::size_t size() const override { return triangles_.size(); }

  bvh::References references(const bvh::LocalFrame& frame,
                             std::span<const std::uint32_t> primitives) const override {
    const bvh::ToLocal to_local(frame);
    const auto box_of = [&](std::size_t index) {
      const TriangleIndices& t = triangles_[index];
      return to_local.box(vertices_[t[0]].data(), vertices_[t[1]].data(), vertices_[t[2]].data());
    };
    if (primitives.empty()) return bvh::references_made(triangles_.size(), box_of);
    bvh::References references(primitives.size());
    for (std::size_t i = 0; i < primitives.size(); ++i)
      references.data[i] = bvh::reference_to(box_of(primitives[i]), primitives[i]);
    return references;
  }

  bvh::Bounds bounds(const bvh::LocalFrame& frame,
                     std::span<const std::uint32_t> primitives) const override {
    bvh::PointPairs low = bvh::load_point(vertices_[triangles_[primitives[0]][0]].data());
    bvh::PointPairs high = low;
    for (const std::uint32_t primitive : primitives) {
      for (const std::uint32_t vertex : triangles_[primitive]) {
        const bvh::PointPairs p = bvh::load_point(vertices_[vertex].data());
        low = bvh::smaller(low, p);
        high = bvh::larger(high, p);
      }
    }
    const double min[3] = {low.xy[0], low.xy[1], low.yz[1]};
    const double max[3] = {high.xy[0], high.xy[1], high.yz[1]};
    return bvh::ToLocal(frame).box(min, max);
  }

  void fill(std::span<const std::uint32_t> primitives, const bvh::LocalFrame& frame,
            const double (&origin)[3], bvh::CornerRows& rows) const override {
    const double scale = std::ldexp(1.0, -frame.exponent);
    for (std::size_t c = 0; c < 3; ++c) {
      float* x = rows.row(c, 0);
      float* y = rows.row(c, 1);
      float* z = rows.row(c, 2);
      for (std::size_t i = 0; i < primitives.size(); ++i) {
        const double* p = vertices_[triangles_[primitives[i]][c]].data();
        x[i] = static_cast<float>((p[0] - frame.centre[0]) * scale - origin[0]);
        y[i] = static_cast<float>((p[1] - frame.centre[1]) * scale - origin[1]);
        z[i] = static_cast<float>((p[2] - frame.centre[2]) * scale - origin[2]);
      }
    }
  }

 private:
  std::span<const Eigen::Vector3d> vertices_;
  std::span<const TriangleIndices> triangles_;
};

}  // namespace

std::shared_ptr<const bvh::WideStock> Mesh::Data::wide_to_inherit() const {
  // In this order: once it has been given up, the mesh's own is there.
  std::shared_ptr<const bvh::WideStock> older = older_wide.get();
  if (!is_wide_made.load(std::memory_order_acquire)) return older;
  return std::make_shared<const bvh::WideStock>(wide->stock());
}

const bvh::WideTree& wide_tree_of(const Mesh& mesh, Work* work) {
  const auto& data = MeshAccess::data(mesh);
  // Each query asks: call_once() takes longer to say that there is nothing to do.
  if (data.is_wide_made.load(std::memory_order_acquire)) return *data.wide;
  std::call_once(data.wide_flag, [&] {
    bvh::in_standard_arithmetic([&] {
      data.corners = std::make_unique<MeshCorners>(data.vertices, data.triangles);
      const std::shared_ptr<const bvh::WideStock> older = data.older_wide.get();
      // Isolated, as the building of the tree is.
      tbb::this_task_arena::isolate([&] {
        data.wide = older != nullptr
                        ? std::make_unique<bvh::WideTree>(data.bounds, *data.corners, *older)
                        : std::make_unique<bvh::WideTree>(data.bounds, *data.corners);
      });
      data.is_wide_made.store(true, std::memory_order_release);
      data.older_wide.set(nullptr);
      if (work != nullptr) ++(older != nullptr ? work->trees_refitted : work->trees_built);
    });
  });
  return *data.wide;
}

}  // namespace graze
