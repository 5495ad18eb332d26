#include <graze/bvh/traverse/traverse_nearest.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/world/shapes/mesh_descent.h>
#include <graze/engine/world/shapes/pair_functions.h>
#include <graze/engine/world/shapes/placed_core.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {

using narrowphase::Core;
using narrowphase::Vec3;

namespace {

/// How a set lies above a plane.
struct Height {
  double height;  ///< of the lowest point, metres; negative below
  double slack;   ///< what it is off by, at most
  Vec3 lowest;
};

Eigen::Vector3d in_world(const Vec3& point, const Eigen::Vector3d& origin) {
  return to_eigen(point + to_vec3(origin));
}

// One support point, off by 31 u of the scale (core_gap.cpp), a dot product by 4 u more, and the
// normal by 11 u.
Height height_of(const Core& core, const PlacedHalfSpace& plane) {
  const Vec3 lowest = rounded_support(core, -plane.normal);
  const double size =
      core.bounding_radius + core.radius + 2 * largest(core.at) + std::abs(plane.offset);
  return {dot(plane.normal, lowest) - plane.offset, 0x40p-53 * size + plane.slack, lowest};
}

struct Situation {
  Eigen::Vector3d origin;
  PlacedHalfSpace plane;
  Height height;
};

Situation beside_plane(const PlacedShapeView& a, const PlacedShapeView& b) {
  const Eigen::Vector3d origin = middle_of(a.shape, a.pose);
  const Core core = core_of(a.shape, a.pose, origin);
  const PlacedHalfSpace plane = placed_half_space(*b.shape.as<HalfSpace>(), b.pose, origin);
  return {origin, plane, height_of(core, plane)};
}

ShapeDistance distance_above(const Height& height, const PlacedHalfSpace& plane,
                             const Eigen::Vector3d& origin) {
  const double lower = std::max(height.height - height.slack, 0.0);
  const Eigen::Vector3d lowest = in_world(height.lowest, origin);
  const Eigen::Vector3d down = to_eigen(-plane.normal);
  if (!(lower > 0)) return {0, 0, lowest, lowest, down, PairStatus::Converged};
  const Vec3 foot = height.lowest - plane.normal * height.height;
  return {height.height, lower, lowest, in_world(foot, origin), down, PairStatus::Converged};
}

bool are_opposite(const Vec3& a, const Vec3& b) {
  return a.x == -b.x && a.y == -b.y && a.z == -b.z;
}

/// Nodes by a lower bound of the height of what is in them, for traverse_nearest().
template <typename Bound>
struct HeightBounds {
  const Bound& bound;
  const double& best;

  double of(std::uint32_t node) const { return bound(node); }
  bool is_missed(double) const { return false; }
  bool is_beyond(double height) const { return height >= best; }
};

/// Walks towards the lowest vertex. A node's box is bounded by the plane turned into the mesh's
/// frame; the slack there is that of MeshDescent, whose box this plane stands in for.
Height lowest_vertex(const PlacedMeshView& mesh, const PlacedHalfSpace& plane,
                     const Eigen::Vector3d& origin, double enough, Work& work) {
  const bvh::Tree& tree = tree_of(mesh.mesh, &work);
  const double* m = mesh.pose.data();
  const double unit = tree.frame.unit();
  const Vec3 from_mesh = to_vec3(origin) - Vec3{m[12], m[13], m[14]};
  double own[3];  // the normal in the mesh's frame
  double base = -plane.offset - dot(plane.normal, from_mesh);
  for (int k = 0; k < 3; ++k) {
    own[k] = dot(plane.normal, Vec3{m[4 * k], m[4 * k + 1], m[4 * k + 2]});
    base += own[k] * tree.frame.centre[k];
  }
  const Aabb& box = mesh.mesh.bounds();
  const double size = 2 * (largest(to_vec3(box.min)) + largest(to_vec3(box.max))) +
                      2 * largest(from_mesh) + std::abs(plane.offset);
  const double law_1 = std::max(std::abs(m[12]), std::max(std::abs(m[13]), std::abs(m[14])));
  const double slack = 0x40p-53 * size + 0x10p-53 * law_1 + plane.slack;
  Height best{std::numeric_limits<double>::infinity(), slack, {}};
  const auto bound = [&](std::uint32_t node) {
    ++work.volume_tests;
    const bvh::FloatBox& b = tree.nodes[node].box;
    double low = 0;
    for (int k = 0; k < 3; ++k)
      low += std::min(own[k] * b.min[k], own[k] * b.max[k]);
    return base + low * unit - slack;
  };
  bvh::traverse_nearest(
      tree, HeightBounds<decltype(bound)>{bound, best.height}, [&](const bvh::Node& leaf) {
        for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
          const Triangle t = narrowphase::place(mesh.pose, mesh.mesh.triangle(tree.primitives[i]));
          for (const Eigen::Vector3d* corner : {&t.a, &t.b, &t.c}) {
            const Vec3 point = to_vec3(*corner) - to_vec3(origin);
            const double height = dot(plane.normal, point) - plane.offset;
            if (height < best.height) best.height = height, best.lowest = point;
          }
        }
        return best.height > enough ? bvh::Walk::Continue : bvh::Walk::Stop;
      });
  return best;
}

struct MeshSituation {
  Eigen::Vector3d origin;
  PlacedHalfSpace plane;
  Height height;
};

MeshSituation mesh_beside_plane(const PlacedShapeView& a, const PlacedShapeView& b, double enough,
                                Work& work) {
  const Mesh& mesh = *b.shape.as<Mesh>();
  const double* m = b.pose.data();
  const Eigen::Vector3d origin(m[12], m[13], m[14]);
  const PlacedHalfSpace plane = placed_half_space(*a.shape.as<HalfSpace>(), a.pose, origin);
  return {origin, plane, lowest_vertex({mesh, b.pose}, plane, origin, enough, work)};
}

}  // namespace

bool intersect_plane(const PlacedShapeView& a, const PlacedShapeView& b) {
  const Height height = beside_plane(a, b).height;
  return !(height.height - height.slack > 0);
}

ShapeDistance distance_to_plane(const PlacedShapeView& a, const PlacedShapeView& b) {
  const Situation s = beside_plane(a, b);
  return distance_above(s.height, s.plane, s.origin);
}

bool intersect_planes(const PlacedShapeView& a, const PlacedShapeView& b) {
  return distance_of_planes(a, b).distance == 0;
}

ShapeDistance distance_of_planes(const PlacedShapeView& a, const PlacedShapeView& b) {
  const Eigen::Vector3d origin = middle_of(a.shape, a.pose);
  const PlacedHalfSpace of_a = placed_half_space(*a.shape.as<HalfSpace>(), a.pose, origin);
  const PlacedHalfSpace of_b = placed_half_space(*b.shape.as<HalfSpace>(), b.pose, origin);
  const Vec3 on_a = of_a.normal * of_a.offset;
  const Vec3 on_b = of_b.normal * of_b.offset;
  const double gap = -of_a.offset - of_b.offset;
  const double slack = of_a.slack + of_b.slack;
  if (are_opposite(of_a.normal, of_b.normal) && gap - slack > 0) {
    return {gap,
            gap - slack,
            in_world(on_a, origin),
            in_world(on_b, origin),
            to_eigen(of_a.normal),
            PairStatus::Converged};
  }
  // Some point deep in both: where -n_a and -n_b point together, unless they are opposite.
  const double cosine = dot(of_a.normal, of_b.normal);
  const double determinant = 1 - cosine * cosine;
  Vec3 common = on_a;
  if (determinant > 0) {
    const double u = (of_a.offset - cosine * of_b.offset) / determinant;
    const double v = (of_b.offset - cosine * of_a.offset) / determinant;
    common = of_a.normal * u + of_b.normal * v;
  } else if (cosine > 0 && of_b.offset < of_a.offset) {
    common = on_b;
  }
  const Eigen::Vector3d point = in_world(common, origin);
  return {0, 0, point, point, to_eigen(of_a.normal), PairStatus::Converged};
}

bool intersect_mesh_plane(const PlacedShapeView& a, const PlacedShapeView& b, Work& work) {
  const Height height = mesh_beside_plane(a, b, 0, work).height;
  return !(height.height - height.slack > 0);
}

ShapeDistance distance_of_mesh_plane(const PlacedShapeView& a, const PlacedShapeView& b,
                                     Work& work) {
  const double never = -std::numeric_limits<double>::infinity();
  const MeshSituation s = mesh_beside_plane(a, b, never, work);
  return mirrored(distance_above(s.height, s.plane, s.origin));
}

}  // namespace graze
