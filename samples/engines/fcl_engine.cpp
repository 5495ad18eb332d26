// FCL behind the pipe, in some thirty lines: what a team writes first that holds its own wrapper of
// FCL against graze.

#include "graze_peer.h"

#include <fcl/fcl.h>

namespace {

using graze_peer::Json;
using Model = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<Model> model_of(const graze_peer::Mesh& mesh) {
  auto model = std::make_shared<Model>();
  model->beginModel();
  const auto at = [&](std::size_t i) { return fcl::Vector3d(mesh.vertices[i].data()); };
  for (const auto& t : mesh.triangles)
    model->addTriangle(at(t[0]), at(t[1]), at(t[2]));
  model->endModel();
  return model;
}

fcl::Transform3d transform_of(const graze_peer::Pose& pose) {
  fcl::Transform3d transform;
  transform.matrix().topRows<3>() =
      Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(pose.data());
  transform.makeAffine();
  return transform;
}

graze_peer::Answer load(const graze_peer::Mesh& mesh_a, const graze_peer::Mesh& mesh_b) {
  return
      [a = model_of(mesh_a), b = model_of(mesh_b)](const graze_peer::Question& question) -> Json {
        const fcl::Transform3d pose_a = transform_of(question.pose_a),
                               pose_b = transform_of(question.pose_b);
        if (question.name == "any") {
          fcl::CollisionResultd result;
          return {{"says", fcl::collide(a.get(), pose_a, b.get(), pose_b, fcl::CollisionRequestd(),
                                        result) > 0}};
        }
        fcl::DistanceResultd result;
        const double distance =
            fcl::distance(a.get(), pose_a, b.get(), pose_b, fcl::DistanceRequestd(), result);
        return {{"distance", distance}};
      };
}

}  // namespace

/// A name may be given: so two versions of FCL, each with a program of its own, stand beside each
/// other.
int main(int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "my-fcl";
  return graze_peer::serve({name, FCL_VERSION, {"any", "distance"}, load});
}
