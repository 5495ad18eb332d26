// CGAL: its class for moving triangle meshes, which walks two trees of boxes against each other and
// decides by EPICK's exact predicates. It takes manifold meshes alone. Assertions are off, as in
// any release build.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Rigid_triangle_mesh_collision_detection.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <memory>

#include "tests/benchmark/pairs/peers/peers.h"

namespace graze::benchmark {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Detection = CGAL::Rigid_triangle_mesh_collision_detection<Surface>;

Surface to_cgal(const Mesh& mesh) {
  Surface surface;
  std::vector<Surface::Vertex_index> vertices;
  for (const Eigen::Vector3d& p : mesh.vertices())
    vertices.push_back(surface.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z())));
  for (const TriangleIndices& t : mesh.triangles()) {
    if (surface.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]) == Surface::null_face())
      throw Error("it takes manifold meshes alone");
  }
  return surface;
}

Kernel::Aff_transformation_3 to_cgal(const Pose& pose) {
  const auto& r = pose.linear();
  const auto& t = pose.translation();
  return {r(0, 0), r(0, 1), r(0, 2), t.x(),   r(1, 0), r(1, 1),
          r(1, 2), t.y(),   r(2, 0), r(2, 1), r(2, 2), t.z()};
}

class CgalPairs final : public PairContestant {
 public:
  CgalPairs() : PairContestant("CGAL") {}

  std::string refusal(Question question) const override {
    if (question == Question::Any) return "";
    return question == Question::Pairs ? "moving meshes are asked for yes or no alone"
                                       : "it has no distance of meshes";
  }
  void build(const Mesh& mesh_a, const Mesh& mesh_b) override {
    release();
    surfaces_ = std::make_unique<std::array<Surface, 2>>();
    (*surfaces_)[0] = to_cgal(mesh_a);
    (*surfaces_)[1] = to_cgal(mesh_b);
    detection_ = std::make_unique<Detection>();
    for (const Surface& surface : *surfaces_)
      detection_->add_mesh(surface, CGAL::parameters::apply_per_connected_component(false));
  }
  void release() override {
    detection_.reset();
    surfaces_.reset();
  }
  bool any(const Pose& pose_b) override {
    detection_->set_transformation(1, to_cgal(pose_b));
    return !detection_->get_all_intersections(0).empty();
  }

 private:
  std::unique_ptr<std::array<Surface, 2>> surfaces_;
  std::unique_ptr<Detection> detection_;
};

}  // namespace

void add_cgal(PairContestants& contestants) {
  contestants.push_back(std::make_unique<CgalPairs>());
}

}  // namespace graze::benchmark
