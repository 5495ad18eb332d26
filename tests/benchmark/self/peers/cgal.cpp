// CGAL's self_intersections() and does_self_intersect(): box_self_intersection_d() on the boxes of
// all faces, neighbours told by halfedges, the rest by its kernel of exact predicates.

#define GRAZE_HAS_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <iterator>
#include <utility>
#include <vector>

#include "tests/benchmark/self/peer.h"

namespace graze::benchmark {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

class Cgal : public SelfPeer {
 public:
  explicit Cgal(Surface surface) : surface_(std::move(surface)) {}

  std::size_t count_pairs() override {
    std::vector<std::pair<Surface::Face_index, Surface::Face_index>> pairs;
    CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(
        surface_, std::back_inserter(pairs));
    return pairs.size();
  }

  bool is_any() override {
    return CGAL::Polygon_mesh_processing::does_self_intersect<CGAL::Sequential_tag>(surface_);
  }

 private:
  Surface surface_;
};

}  // namespace

std::unique_ptr<SelfPeer> make_cgal_self(const Mesh& mesh) {
  Surface surface;
  std::vector<Surface::Vertex_index> vertices;
  vertices.reserve(mesh.vertices().size());
  for (const Eigen::Vector3d& p : mesh.vertices())
    vertices.push_back(surface.add_vertex({p.x(), p.y(), p.z()}));
  for (const TriangleIndices& t : mesh.triangles()) {
    const auto corner = [&](int k) { return vertices[mesh.welded()[t[k]]]; };
    if (surface.add_face(corner(0), corner(1), corner(2)) == Surface::null_face()) return nullptr;
  }
  return std::make_unique<Cgal>(std::move(surface));
}

}  // namespace graze::benchmark
