#include "samples/simulation/scenes/parts.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace graze::samples {

using Eigen::Vector3d;

Shape as(Surface surface, const Shape& shape, const Fineness& fineness) {
  return surface == Surface::Analytic ? shape : Shape(surface_of(shape, fineness));
}

const char* name_of(Surface surface) {
  return surface == Surface::Analytic ? "shape" : "mesh";
}

Pose at(const Vector3d& place) {
  Pose pose = Pose::Identity();
  pose.translation() = place;
  return pose;
}

Pose at(const Vector3d& place, double radians, const Vector3d& axis) {
  Pose pose = at(place);
  pose.linear() = Eigen::AngleAxisd(radians, axis.normalized()).toRotationMatrix();
  return pose;
}

SceneBody floor_of(Surface surface, double half_width, int cells) {
  const Box slab{{half_width, half_width, 0.25}};
  return {.name = "floor",
          .shape = as(surface, slab, {.cells = cells}),
          .pose = at({0, 0, -0.25}),
          .hold = Hold::Fixed};
}

ConvexHull drum(double radius, double half_height) {
  std::vector<Vector3d> points;
  for (int i = 0; i < 12; ++i) {
    const double angle = std::numbers::pi * i / 6;
    const double height = i % 2 == 0 ? -half_height : half_height;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
  }
  return ConvexHull(points);
}

}  // namespace graze::samples
