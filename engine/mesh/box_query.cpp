#include <graze/bvh/box_separation.h>
#include <graze/bvh/error.h>
#include <graze/bvh/traverse_volume.h>
#include <graze/engine/mesh/box_query.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query_results.h>
#include <graze/engine/mesh/relative_frame.h>
#include <graze/narrowphase/triangle_box.h>

#include <array>
#include <cmath>
#include <string>

namespace graze {
namespace {

/// A box as both kinds of query see it: an axis-aligned box in a frame of its own.
struct FramedBox {
  Aabb box;
  Pose frame;
  double deviation;
  enum class Kind { AxisAligned, Oriented } kind;
};

FramedBox framed(const Aabb& box) {
  check_box(box, "box");
  return {box, Pose::Identity(), 0, FramedBox::Kind::AxisAligned};
}

FramedBox framed(const Obb& box) {
  check_box(box, "box");
  FramedBox result{{}, box.pose, rotation_deviation(box.pose), FramedBox::Kind::Oriented};
  for (int k = 0; k < 3; ++k) {
    result.box.min.data()[k] = -box.half_extents.data()[k];
    result.box.max.data()[k] = box.half_extents.data()[k];
  }
  return result;
}

/// Refuses a mesh that could overflow on its way into the frame of an oriented box (law 3), where
/// the answer would depend on what the tree prunes. The sums are in the order of into_frame(), and
/// rounding is monotone: if these are finite, so is every intermediate result.
void check_way_into_frame(const PlacedMesh& placed, const FramedBox& box) {
  if (box.kind != FramedBox::Kind::Oriented) return;
  std::array<double, 3> way = placed_reach(placed.pose, placed.mesh.bounds());
  const double* m = box.frame.data();  // column-major 4x4: column i is the frame's axis i
  for (int i = 0; i < 3; ++i)
    way[i] += std::abs(m[12 + i]);
  for (int i = 0; i < 3; ++i) {
    const double* axis = m + 4 * i;
    const double reach =
        (std::abs(axis[0]) * way[0] + std::abs(axis[1]) * way[1]) + std::abs(axis[2]) * way[2];
    if (!std::isfinite(reach)) {
      throw PoseError(std::string("box: coordinate ") + "xyz"[i] +
                      " of the mesh in its frame could overflow");
    }
  }
}

bool meet(const Triangle& placed, const FramedBox& box, Work& work) {
  ++work.triangle_tests;
  const Triangle triangle =
      box.kind == FramedBox::Kind::Oriented ? narrowphase::into_frame(placed, box.frame) : placed;
  const narrowphase::Decision decision = narrowphase::decide(triangle, box.box);
  work.exact_tests += decision.stage == narrowphase::Stage::Exact;
  return decision.is_hit;
}

/// Calls `on_triangle(index)` for each placed triangle that meets the box, until it answers Stop.
template <typename OnTriangle>
void for_each_triangle(const PlacedMesh& placed, const FramedBox& box, Work& work,
                       OnTriangle&& on_triangle) {
  const double deviation = check_placement(placed.pose, placed.mesh.bounds(), "pose of the mesh");
  check_way_into_frame(placed, box);
  const bvh::Tree& tree = placed.mesh.tree(&work);
  const bvh::LocalFrame frame = bvh::LocalFrame::around(box.box);
  const bvh::FloatBox local = frame.to_local(box.box);
  const bvh::BoxSeparation box_test(
      relative_frame({placed.pose, deviation, tree.frame, placed.mesh.bounds()},
                     {box.frame, box.deviation, frame, box.box}));
  const auto is_apart = [&](const bvh::Node& node) {
    ++work.volume_tests;
    const bool is_pruned = box_test.are_apart(node.box, local);
    work.volume_rejections += is_pruned;
    return is_pruned;
  };
  const auto test_leaf = [&](const bvh::Node& leaf) {
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
      const std::uint32_t index = tree.primitives[i];
      if (!meet(place(placed.pose, placed.mesh.triangle(index)), box, work)) continue;
      if (on_triangle(index) == bvh::Walk::Stop) return bvh::Walk::Stop;
    }
    return bvh::Walk::Continue;
  };
  bvh::traverse_volume(tree, is_apart, test_leaf);
}

bool meets_any(const PlacedMesh& mesh, const FramedBox& box, Work* work) {
  CountedWork counted(work);
  return has_any(
      [&](auto&& on_triangle) { for_each_triangle(mesh, box, counted.work(), on_triangle); });
}

TriangleList find_all(const PlacedMesh& mesh, const FramedBox& box, const BoxSettings& settings,
                      Work* work) {
  CountedWork counted(work);
  TriangleList found;
  found.completeness = collect(found.triangles, settings.limit, [&](auto&& on_triangle) {
    for_each_triangle(mesh, box, counted.work(), on_triangle);
  });
  return found;
}

}  // namespace

bool intersects(const PlacedMesh& mesh, const Aabb& box, Work* work) {
  return meets_any(mesh, framed(box), work);
}

bool intersects(const PlacedMesh& mesh, const Obb& box, Work* work) {
  return meets_any(mesh, framed(box), work);
}

TriangleList find_triangles(const PlacedMesh& mesh, const Aabb& box, const BoxSettings& settings,
                            Work* work) {
  return find_all(mesh, framed(box), settings, work);
}

TriangleList find_triangles(const PlacedMesh& mesh, const Obb& box, const BoxSettings& settings,
                            Work* work) {
  return find_all(mesh, framed(box), settings, work);
}

}  // namespace graze
