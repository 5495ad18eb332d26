#include <graze/engine/compare/fcl_geometry.h>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/geometry/shape/plane.h>
#include <fcl/geometry/shape/sphere.h>
#include <graze/engine/world/shapes/hull_data.h>
#include <graze/narrowphase/convex/core/hull.h>
#include <vector>

// The linked FCL was compiled for the baseline (engine/compare/fcl_engine.cpp).
static_assert(EIGEN_MAX_ALIGN_BYTES == 16, "compile this file without -march or -mavx flags");

namespace graze::compare {
namespace {

FclGeometry converted(const Sphere& s) {
  return {std::make_shared<fcl::Sphered>(s.radius), s.centre};
}

FclGeometry converted(const Box& s) {
  const Eigen::Vector3d sides = 2 * s.half_extents;
  return {std::make_shared<fcl::Boxd>(sides.x(), sides.y(), sides.z())};
}

FclGeometry converted(const Capsule& s) {
  return {std::make_shared<fcl::Capsuled>(s.radius, 2 * s.half_length)};
}

FclGeometry converted(const Cylinder& s) {
  return {std::make_shared<fcl::Cylinderd>(s.radius, 2 * s.half_height)};
}

FclGeometry converted(const Cone& s) {
  return {std::make_shared<fcl::Coned>(s.radius, 2 * s.half_height)};
}

FclGeometry converted(const Ellipsoid& s) {
  const Eigen::Vector3d& a = s.semi_axes;
  return {std::make_shared<fcl::Ellipsoidd>(a.x(), a.y(), a.z()), s.centre};
}

FclGeometry converted(const HalfSpace& s) {
  return {std::make_shared<fcl::Halfspaced>(s.normal, s.offset)};
}

FclGeometry converted(const Plane& s) {
  return {std::make_shared<fcl::Planed>(s.normal, s.offset)};
}

FclGeometry converted(const ConvexHull& s) {
  const narrowphase::Hull& hull = data_of(s);
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const auto& c : hull.corners)
    vertices->emplace_back(c.x, c.y, c.z);
  auto faces = std::make_shared<std::vector<int>>();
  for (const auto& face : hull.faces) {
    faces->push_back(static_cast<int>(face.count));
    for (std::uint32_t i = 0; i < face.count; ++i)
      faces->push_back(static_cast<int>(hull.loops[face.first + i]));
  }
  const int count = static_cast<int>(hull.faces.size());
  return {std::make_shared<fcl::Convexd>(vertices, count, faces),
          {hull.middle.x, hull.middle.y, hull.middle.z}};
}

FclGeometry converted(const Mesh& mesh) {
  std::vector<fcl::Vector3d> vertices(mesh.vertices().begin(), mesh.vertices().end());
  std::vector<fcl::Triangle> triangles;
  for (const TriangleIndices& t : mesh.triangles())
    triangles.emplace_back(t[0], t[1], t[2]);
  auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  model->beginModel();
  model->addSubModel(vertices, triangles);
  model->endModel();
  return {model};
}

FclGeometry converted(const HeightField& field) {
  return converted(field.mesh());
}

}  // namespace

FclGeometry fcl_geometry(const Shape& shape) {
  return std::visit([](const auto& value) { return converted(value); }, shape.value());
}

fcl::Transform3d fcl_transform(const Pose& pose, const Eigen::Vector3d& centre) {
  fcl::Transform3d transform = fcl::Transform3d::Identity();
  transform.linear() = pose.linear();
  transform.translation() = pose * centre;
  return transform;
}

}  // namespace graze::compare
