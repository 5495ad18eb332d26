#include <graze/bvh/box_pair_test.h>
#include <graze/bvh/error.h>
#include <graze/bvh/traverse_volume.h>
#include <graze/engine/mesh/box_query.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/relative_frame.h>
#include <graze/narrowphase/triangle_box.h>

#include <algorithm>
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
/// the answer would depend on what the tree prunes. The sums are in the order of place() and
/// into_frame(), and rounding is monotone: if these are finite, so is every intermediate result.
void check_way_into_frame(const Pose& pose, const Aabb& bounds, const FramedBox& box) {
  if (box.kind != FramedBox::Kind::Oriented) return;
  const double* m = pose.data();
  const double* f = box.frame.data();
  double largest[3];
  double way[3];
  for (int k = 0; k < 3; ++k) {
    largest[k] = std::max(std::abs(bounds.min.data()[k]), std::abs(bounds.max.data()[k]));
  }
  for (int i = 0; i < 3; ++i) {
    const double placed = ((std::abs(m[i]) * largest[0] + std::abs(m[4 + i]) * largest[1]) +
                           std::abs(m[8 + i]) * largest[2]) +
                          std::abs(m[12 + i]);
    way[i] = placed + std::abs(f[12 + i]);
  }
  for (int i = 0; i < 3; ++i) {
    const double* axis = f + 4 * i;
    const double reach =
        (std::abs(axis[0]) * way[0] + std::abs(axis[1]) * way[1]) + std::abs(axis[2]) * way[2];
    if (!std::isfinite(reach)) {
      throw PoseError(std::string("box: coordinate ") + "xyz"[i] +
                      " of the mesh in its frame could overflow");
    }
  }
}

bool meet(const Triangle& placed, const FramedBox& box, Work& work) {
  using narrowphase::Verdict;
  ++work.triangle_tests;
  const Triangle triangle =
      box.kind == FramedBox::Kind::Oriented ? narrowphase::into_frame(placed, box.frame) : placed;
  const Verdict verdict = narrowphase::triage(triangle, box.box);
  if (verdict != Verdict::Unsure) return verdict == Verdict::Touching;
  ++work.exact_tests;
  return narrowphase::intersects_exactly(triangle, box.box);
}

/// Calls `on_triangle(index)` for each placed triangle that meets the box, until it answers Stop.
template <typename OnTriangle>
void for_each_triangle(const PlacedMesh& placed, const FramedBox& box, Work& work,
                       OnTriangle&& on_triangle) {
  const double deviation = check_placement(placed.pose, placed.mesh.bounds(), "pose of the mesh");
  check_way_into_frame(placed.pose, placed.mesh.bounds(), box);
  const bvh::Tree& tree = placed.mesh.tree(&work);
  const bvh::LocalFrame frame = bvh::LocalFrame::around(box.box);
  const bvh::FloatBox local = frame.to_local(box.box);
  const bvh::BoxPairTest box_test(
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
  Work counted;
  bool has_triangle = false;
  for_each_triangle(mesh, box, counted, [&](std::uint32_t) {
    has_triangle = true;
    return bvh::Walk::Stop;
  });
  if (work != nullptr) *work += counted;
  return has_triangle;
}

TriangleList find_all(const PlacedMesh& mesh, const FramedBox& box, const BoxSettings& settings,
                      Work* work) {
  Work counted;
  TriangleList found;
  for_each_triangle(mesh, box, counted, [&](std::uint32_t index) {
    if (found.triangles.size() == settings.limit) {
      found.completeness = Completeness::LimitReached;
      return bvh::Walk::Stop;
    }
    found.triangles.push_back(index);
    return bvh::Walk::Continue;
  });
  std::sort(found.triangles.begin(), found.triangles.end());
  if (work != nullptr) *work += counted;
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
