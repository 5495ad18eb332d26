// CGAL's tree and its test of sides, with the kernel that its manual takes for both: predicates are
// exact, the nearest points are rounded.

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "tests/benchmark/points/contestant.h"

namespace graze::benchmark {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Surface>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
using Side = CGAL::Side_of_triangle_mesh<Surface, Kernel>;

Kernel::Point_3 to_cgal(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

class Cgal : public PointContestant {
 public:
  Cgal() : PointContestant("cgal") {}

  void build(const Mesh& mesh) override {
    side_.reset(), tree_.reset();
    surface_ = {};
    std::vector<Surface::Vertex_index> vertices;
    for (const Eigen::Vector3d& vertex : mesh.vertices())
      vertices.push_back(surface_.add_vertex(to_cgal(vertex)));
    for (const TriangleIndices& t : mesh.triangles()) {
      const auto face =
          surface_.add_face(vertices[mesh.welded()[t[0]]], vertices[mesh.welded()[t[1]]],
                            vertices[mesh.welded()[t[2]]]);
      if (face == Surface::null_face()) throw std::runtime_error("CGAL refuses a triangle");
    }
    tree_ = std::make_unique<Tree>(faces(surface_).first, faces(surface_).second, surface_);
    tree_->accelerate_distance_queries();
    side_ = std::make_unique<Side>(*tree_);
  }

  double ask(PointQuestion question, std::span<const Eigen::Vector3d> points) override {
    double sum = 0;
    for (const Eigen::Vector3d& each : points) {
      const Kernel::Point_3 point = to_cgal(each);
      const bool is_inside =
          question != PointQuestion::Nearest && (*side_)(point) != CGAL::ON_UNBOUNDED_SIDE;
      if (question == PointQuestion::Inside) {
        sum += is_inside;
        continue;
      }
      const double distance = std::sqrt(tree_->squared_distance(point));
      sum += is_inside ? -distance : distance;
    }
    return sum;
  }

 private:
  Surface surface_;
  std::unique_ptr<Tree> tree_;
  std::unique_ptr<Side> side_;
};

}  // namespace

std::unique_ptr<PointContestant> make_cgal_points() {
  return std::make_unique<Cgal>();
}

}  // namespace graze::benchmark
