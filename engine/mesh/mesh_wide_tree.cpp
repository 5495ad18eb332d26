#include <graze/bvh/to_local.h>
#include <graze/engine/mesh/mesh_data.h>
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

const bvh::WideTree& Mesh::wide_tree(Work* work) const {
  std::call_once(data_->wide_flag, [&] {
    data_->corners = std::make_unique<MeshCorners>(data_->vertices, data_->triangles);
    // Isolated, as the building of the tree is.
    tbb::this_task_arena::isolate(
        [&] { data_->wide = std::make_unique<bvh::WideTree>(data_->bounds, *data_->corners); });
    if (work != nullptr) ++work->trees_built;
  });
  return *data_->wide;
}

}  // namespace graze
