// FCL before the hard cases, without graze: fcl_hard_cases FOLDER.

#include "hard_cases.h"

#include <fcl/fcl.h>

namespace {

using hard_cases::Json;
using Model = fcl::BVHModel<fcl::OBBRSSd>;

Model model_of(const hard_cases::PlacedMesh& mesh) {
  Model model;
  model.beginModel();
  const auto at = [&](std::size_t i) { return fcl::Vector3d(mesh.vertices[i].data()); };
  for (const auto& t : mesh.triangles)
    model.addTriangle(at(t[0]), at(t[1]), at(t[2]));
  model.endModel();
  return model;
}

std::optional<Json> answer(const Json& query) {
  const auto a = hard_cases::mesh_of(query.at("a"));
  const auto b = hard_cases::mesh_of(query.at("b"));
  if (!a || !b || query.contains("settings")) return std::nullopt;
  const Model model_a = model_of(*a), model_b = model_of(*b);
  const fcl::Transform3d here = fcl::Transform3d::Identity();
  if (query.at("question") == "any") {
    fcl::CollisionResultd result;
    return Json{{"says", fcl::collide(&model_a, here, &model_b, here, fcl::CollisionRequestd(),
                                      result) > 0}};
  }
  if (query.at("question") != "distance") return std::nullopt;
  fcl::DistanceResultd result;
  const double distance =
      fcl::distance(&model_a, here, &model_b, here, fcl::DistanceRequestd(), result);
  return Json{{"distance", std::max(distance, 0.0)}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: fcl_hard_cases FOLDER\n", stderr);
    return 2;
  }
  hard_cases::scoreboard(argv[1], answer);
}
