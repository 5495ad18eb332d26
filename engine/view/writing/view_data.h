#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <graze/bvh/aabb.h>
#include <graze/engine/view/shapes/triangulate.h>
#include <graze/engine/view/view.h>

#include <Eigen/Core>

namespace graze::view {

/// Holds a surface that bodies share.
struct ShownShape {
  Triangulation surface;
  Aabb bounds;                    ///< the box of the vertices
  std::optional<Mesh> mesh = {};  ///< the handle that it was made of
};

struct ShownBodyData {
  std::string name;
  std::size_t shape;  ///< the shape's index
  std::optional<std::array<std::uint8_t, 3>> color;
  std::map<std::uint32_t, std::vector<Obb>> boxes = {};  ///< boxes by level, in the body's own
                                                         ///< frame
};

struct ShownContact {
  Eigen::Vector3d point;
  Eigen::Vector3d normal;  ///< a unit vector
  double depth;
};

struct ShownGap {
  Eigen::Vector3d point_a;
  Eigen::Vector3d point_b;
  double distance;
};

struct ShownLabel {
  Eigen::Vector3d at;
  std::string text;
};

/// Holds one picture. Lines are pairs of points.
struct ShownFrame {
  ViewFrame said;
  std::map<std::uint32_t, Pose> poses = {};  ///< poses by body
  std::map<std::uint32_t, std::vector<std::uint32_t>> triangles =
      {};  ///< the marked triangles by body
  std::vector<Eigen::Vector3d> curves = {};
  std::vector<Eigen::Vector3d> lines = {};
  std::vector<ShownContact> contacts = {};
  std::vector<ShownGap> gaps = {};
  std::vector<ShownLabel> labels = {};
  std::vector<Eigen::Vector3d> points = {};
  std::vector<ViewPlane> planes = {};                            ///< planes with unit normals
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs = {};  ///< pairs of bodies, the lower
                                                                 ///< first
};

/// Holds all of a view.
struct ShownView {
  ViewSettings settings;
  std::vector<ShownShape> shapes = {};
  std::vector<ShownBodyData> bodies = {};
  std::vector<ShownFrame> frames = {};
};

}  // namespace graze::view
