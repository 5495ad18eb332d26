#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/skins/skin_of_one.h>
#include <graze/bvh/traverse/traverse_volume.h>
#include <graze/bvh/value/checks.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/inside/parity.h>
#include <graze/engine/mesh/inside/solid.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/placing/relative_frame.h>
#include <graze/engine/mesh/query/node_volumes.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/volume_query.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/box_frame.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>
#include <graze/narrowphase/volumes/spheres/triangle_sphere_stages.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace graze {
namespace {

/// The volume that a query asks about, as all kinds of query see it: a box in a frame of its own,
/// and the ball in it if that is meant.
struct FramedVolume {
  enum class Kind { AxisAligned, Oriented, Ball } kind;
  Aabb box;
  Pose frame = Pose::Identity();
  double deviation = 0;
  Sphere ball = {Eigen::Vector3d::Zero(), 0};
};

FramedVolume framed(const Aabb& box) {
  bvh::check_box(box, "box");
  return {.kind = FramedVolume::Kind::AxisAligned, .box = box};
}

FramedVolume framed(const Obb& box) {
  bvh::check_box(box, "box");
  FramedVolume result{.kind = FramedVolume::Kind::Oriented,
                      .box = {-box.half_extents, box.half_extents},
                      .frame = box.pose,
                      .deviation = rotation_deviation(box.pose)};
  return result;
}

/// Frames a ball. The part of its box beyond the range of double does not matter: no vertex is
/// there.
FramedVolume framed(const Sphere& ball) {
  bvh::check_sphere(ball, "sphere");
  constexpr double kLargest = std::numeric_limits<double>::max();
  FramedVolume result{.kind = FramedVolume::Kind::Ball, .box = {}, .ball = ball};
  for (int k = 0; k < 3; ++k) {
    const double centre = ball.centre.data()[k];
    const double low = std::nextafter(centre - ball.radius, -kLargest);
    const double high = std::nextafter(centre + ball.radius, kLargest);
    result.box.min.data()[k] = std::max(low, -kLargest);
    result.box.max.data()[k] = std::min(high, kLargest);
  }
  return result;
}

/// The volumes of such a query as the skins of a tree of one node, so that the separations serve it
/// too.
class SkinsOfOne {
 public:
  SkinsOfOne(const FramedVolume& volume, const bvh::LocalFrame& frame)
      : node_{frame.to_local(volume.box), 0, 1},
        sphere_(bvh::sphere_around(node_.box)),
        obb_(bvh::obb_around(node_.box)),
        kdop_(bvh::kdop_around(node_.box)) {
    if (volume.kind != FramedVolume::Kind::Ball) return;
    sphere_ = bvh::to_local(frame, volume.ball);
    kdop_ = bvh::kdop_around(sphere_);
  }

  NodeVolumes volumes() const { return {{&node_, 1}, {&sphere_, 1}, {&obb_, 1}, {&kdop_, 1}}; }

 private:
  bvh::Node node_;
  bvh::FloatSphere sphere_;
  bvh::FloatObb obb_;
  bvh::FloatKDop kdop_;
};

/// Refuses a mesh that could overflow in the frame of an oriented box (law 3), where
/// the answer would depend on what the tree prunes. The sums are in the order of into_frame(), and
/// rounding is monotone: if these are finite, so is every intermediate result.
void check_in_frame(const PlacedMeshView& placed, const FramedVolume& box) {
  if (box.kind != FramedVolume::Kind::Oriented) return;
  std::array<double, 3> coordinates = largest_coordinates(placed.pose, placed.mesh.bounds());
  const double* m = box.frame.data();  // column-major 4x4: column i is the frame's axis i
  for (int i = 0; i < 3; ++i)
    coordinates[i] += std::abs(m[12 + i]);
  for (int i = 0; i < 3; ++i) {
    const double* axis = m + 4 * i;
    const double coordinate =
        (std::abs(axis[0]) * coordinates[0] + std::abs(axis[1]) * coordinates[1]) +
        std::abs(axis[2]) * coordinates[2];
    if (!std::isfinite(coordinate)) {
      throw PoseError(std::string("box: coordinate ") + "xyz"[i] +
                      " of the mesh in its frame could overflow");
    }
  }
}

narrowphase::Decision decide(const Triangle& placed, const FramedVolume& volume) {
  switch (volume.kind) {
    case FramedVolume::Kind::Oriented:
      return narrowphase::decide(narrowphase::into_frame(placed, volume.frame), volume.box);
    case FramedVolume::Kind::Ball:
      return narrowphase::decide(placed, volume.ball);
    default:
      return narrowphase::decide(placed, volume.box);
  }
}

bool meet(const Triangle& placed, const FramedVolume& volume, Work& work) {
  ++work.triangle_tests;
  const narrowphase::Decision decision = decide(placed, volume);
  work.exact_tests += decision.stage == narrowphase::Stage::Exact;
  return decision.is_hit;
}

/// Calls `on_triangle(index)` for each placed triangle that meets the volume, until it answers
/// Stop.
template <typename OnTriangle>
void for_each_triangle(const PlacedMeshView& placed, const FramedVolume& asked, Volume volume,
                       Work& work, OnTriangle&& on_triangle) {
  const double deviation = check_placement(placed.pose, placed.mesh.bounds(), "pose of the mesh");
  check_in_frame(placed, asked);
  const NodeVolumes volumes = volumes_of(placed.mesh, volume, work);
  const bvh::Tree& tree = tree_of(placed.mesh);
  const bvh::LocalFrame frame = bvh::LocalFrame::around(asked.box);
  const SkinsOfOne skins(asked, frame);
  const bvh::RelativeFrame relative =
      relative_frame({placed.pose, deviation, tree.frame, placed.mesh.bounds()},
                     {asked.frame, asked.deviation, frame, asked.box});
  const auto test_leaf = [&](const bvh::Node& leaf) {
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
      const std::uint32_t index = tree.primitives[i];
      if (!meet(narrowphase::place(placed.pose, placed.mesh.triangle(index)), asked, work))
        continue;
      if (on_triangle(index) == bvh::Walk::Stop) return bvh::Walk::Stop;
    }
    return bvh::Walk::Continue;
  };
  with_separation(volume, relative, volumes, skins.volumes(), [&](const auto& separation) {
    const CountedSeparation counted(separation, work);
    const auto is_apart = [&](std::uint32_t node) { return counted.are_apart(node, 0); };
    bvh::traverse_volume(tree, is_apart, test_leaf);
  });
}

/// True if a volume that does not touch the surface is inside: one of its points decides for all.
bool is_inside(const FramedVolume& asked, const PlacedMeshView& mesh, Work& work) {
  switch (asked.kind) {
    case FramedVolume::Kind::Oriented:
      return is_moved_centre_enclosed(mesh, {asked.frame, asked.box.max}, work);
    case FramedVolume::Kind::Ball:
      return is_moved_point_enclosed(mesh, asked.ball.centre, work);
    default:
      return is_moved_point_enclosed(mesh, asked.box.min, work);
  }
}

bool meets_any(const PlacedMeshView& mesh, const FramedVolume& asked,
               const VolumeQuerySettings& settings, Work* work) {
  check_interior(settings.interior);
  if (settings.interior == Interior::Solid) check_closed(mesh.mesh, "the mesh");
  CountedWork counted(work);
  const bool is_touching = has_any([&](auto&& on_triangle) {
    for_each_triangle(mesh, asked, settings.volume, counted.work(), on_triangle);
  });
  return is_touching ||
         (settings.interior == Interior::Solid && is_inside(asked, mesh, counted.work()));
}

TriangleList find_all(const PlacedMeshView& mesh, const FramedVolume& asked,
                      const TriangleSettings& settings, Work* work) {
  CountedWork counted(work);
  TriangleList found;
  found.completeness = collect(found.triangles, settings.limit, [&](auto&& on_triangle) {
    for_each_triangle(mesh, asked, settings.volume, counted.work(), on_triangle);
  });
  return found;
}

}  // namespace

bool intersects(const PlacedMeshView& mesh, const Aabb& box, Work* work) {
  return bvh::in_standard_arithmetic(
      [&]() -> bool { return meets_any(mesh, framed(box), {}, work); });
}

bool intersects(const PlacedMeshView& mesh, const Obb& box, Work* work) {
  return bvh::in_standard_arithmetic(
      [&]() -> bool { return meets_any(mesh, framed(box), {}, work); });
}

bool intersects(const PlacedMeshView& mesh, const Sphere& sphere, Work* work) {
  return bvh::in_standard_arithmetic(
      [&]() -> bool { return meets_any(mesh, framed(sphere), {}, work); });
}

bool intersects(const PlacedMeshView& mesh, const Aabb& box, const VolumeQuerySettings& settings,
                Work* work) {
  return bvh::in_standard_arithmetic(
      [&]() -> bool { return meets_any(mesh, framed(box), settings, work); });
}

bool intersects(const PlacedMeshView& mesh, const Obb& box, const VolumeQuerySettings& settings,
                Work* work) {
  return bvh::in_standard_arithmetic(
      [&]() -> bool { return meets_any(mesh, framed(box), settings, work); });
}

bool intersects(const PlacedMeshView& mesh, const Sphere& sphere,
                const VolumeQuerySettings& settings, Work* work) {
  return bvh::in_standard_arithmetic(
      [&]() -> bool { return meets_any(mesh, framed(sphere), settings, work); });
}

TriangleList find_triangles(const PlacedMeshView& mesh, const Aabb& box,
                            const TriangleSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic(
      [&]() -> TriangleList { return find_all(mesh, framed(box), settings, work); });
}

TriangleList find_triangles(const PlacedMeshView& mesh, const Obb& box,
                            const TriangleSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic(
      [&]() -> TriangleList { return find_all(mesh, framed(box), settings, work); });
}

TriangleList find_triangles(const PlacedMeshView& mesh, const Sphere& sphere,
                            const TriangleSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic(
      [&]() -> TriangleList { return find_all(mesh, framed(sphere), settings, work); });
}

}  // namespace graze
