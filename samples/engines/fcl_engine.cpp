// FCL behind the pipe, meshes and shapes: what a team writes first that holds its own wrapper of
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
        if (question.name != "distance") throw graze_peer::Unsupported("of shapes alone");
        fcl::DistanceResultd result;
        const double distance =
            fcl::distance(a.get(), pose_a, b.get(), pose_b, fcl::DistanceRequestd(), result);
        return {{"distance", distance}};
      };
}

/// Where a shape stands in its own frame, and what it is. FCL's shapes have their middle at 0.
struct Shape {
  std::shared_ptr<fcl::CollisionGeometryd> geometry;
  fcl::Vector3d centre = fcl::Vector3d::Zero();
};

fcl::Vector3d point_of(const std::array<double, 3>& p) {
  return fcl::Vector3d(p.data());
}

Shape shape_of(const Json& json) {
  const std::string& kind = json.begin().key();
  const Json& of = json.begin().value();
  const auto number = [&](const char* name) { return of.at(name).get<double>(); };
  const auto twice = [&](const char* half) { return 2 * number(half); };
  if (kind == "sphere")
    return {std::make_shared<fcl::Sphered>(number("radius")), point_of(of.at("centre"))};
  if (kind == "box") return {std::make_shared<fcl::Boxd>(2 * point_of(of.at("half_extents")))};
  if (kind == "capsule")
    return {std::make_shared<fcl::Capsuled>(number("radius"), twice("half_length"))};
  if (kind == "cylinder")
    return {std::make_shared<fcl::Cylinderd>(number("radius"), twice("half_height"))};
  if (kind == "cone") return {std::make_shared<fcl::Coned>(number("radius"), twice("half_height"))};
  if (kind == "ellipsoid")
    return {std::make_shared<fcl::Ellipsoidd>(point_of(of.at("semi_axes"))),
            point_of(of.at("centre"))};
  return {};
}

Json contacts_of(const fcl::CollisionResultd& result) {
  Json manifold = Json::array();
  for (std::size_t i = 0; i < result.numContacts(); ++i) {
    const fcl::Contactd& c = result.getContact(i);
    manifold.push_back({{"point", {c.pos.x(), c.pos.y(), c.pos.z()}},
                        {"normal", {c.normal.x(), c.normal.y(), c.normal.z()}},
                        {"depth", c.penetration_depth}});
  }
  return {{"manifold", manifold}};
}

graze_peer::ShapesAnswer load_shapes(const std::vector<Json>& loaded) {
  std::vector<Shape> shapes;
  for (const Json& each : loaded)
    shapes.push_back(shape_of(each));
  return [shapes](const graze_peer::Question& question, std::size_t a, std::size_t b) -> Json {
    const Shape& shape_a = shapes.at(a);
    const Shape& shape_b = shapes.at(b);
    if (!shape_a.geometry || !shape_b.geometry) throw graze_peer::Unsupported("no such shape");
    fcl::Transform3d pose_a = transform_of(question.pose_a), pose_b = transform_of(question.pose_b);
    pose_a.translation() = pose_a * shape_a.centre;
    pose_b.translation() = pose_b * shape_b.centre;
    if (question.name == "distance") {
      fcl::DistanceResultd result;
      return {{"distance", fcl::distance(shape_a.geometry.get(), pose_a, shape_b.geometry.get(),
                                         pose_b, fcl::DistanceRequestd(), result)}};
    }
    const bool has_contacts = question.name == "contacts";
    fcl::CollisionResultd result;
    const std::size_t hits =
        fcl::collide(shape_a.geometry.get(), pose_a, shape_b.geometry.get(), pose_b,
                     fcl::CollisionRequestd(has_contacts ? 100 : 1, has_contacts), result);
    return has_contacts ? contacts_of(result) : Json{{"says", hits > 0}};
  };
}

}  // namespace

/// A name may be given: so two versions of FCL, each with a program of its own, stand beside each
/// other.
int main(int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "my-fcl";
  return graze_peer::serve({name, FCL_VERSION, {"any", "distance", "contacts"}, load, load_shapes});
}
