#include <graze/engine/compare/judge/rational/mesh_referee.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>
#include <graze/engine/compare/judge/rational/sure_pair.h>
#include <graze/engine/compare/referee.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/triangle_distance.h>

#include <algorithm>
#include <limits>

namespace graze::compare {
namespace {

bool share_a_box(const Triangle& a, const Triangle& b) {
  const Eigen::Vector3d min_a = a.a.cwiseMin(a.b).cwiseMin(a.c);
  const Eigen::Vector3d max_a = a.a.cwiseMax(a.b).cwiseMax(a.c);
  const Eigen::Vector3d min_b = b.a.cwiseMin(b.b).cwiseMin(b.c);
  const Eigen::Vector3d max_b = b.a.cwiseMax(b.b).cwiseMax(b.c);
  return (min_a.array() <= max_b.array()).all() && (min_b.array() <= max_a.array()).all();
}

}  // namespace

MeshReferee::Surface::Surface(const PlacedMeshView& mesh)
    : known_(referee_mesh(mesh.mesh)), pose_(mesh.pose) {}

Triangle MeshReferee::Surface::triangle(std::uint32_t index) const {
  return place(pose_, known_->mesh().triangle(index));
}

const std::vector<Triangle>& MeshReferee::Surface::triangles() const {
  std::call_once(once_, [&] {
    const auto count = static_cast<std::uint32_t>(known_->mesh().triangles().size());
    triangles_.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i)
      triangles_.push_back(triangle(i));
  });
  return triangles_;
}

MeshReferee::MeshReferee(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b, Touch touch)
    : touch_(touch), a_(mesh_a), b_(mesh_b) {}

bool MeshReferee::is_hit(const Triangle& a, const Triangle& b) const {
  const std::optional<bool> sure = surely_intersects(a, b);
  const bool is_crossing_asked = touch_ == Touch::Exclude;
  if (sure && (!*sure || !is_crossing_asked)) return *sure;
  if (!sure && !referee_intersects(a, b)) return false;
  return !is_crossing_asked || do_cross(exactly(a), exactly(b));
}

bool MeshReferee::is_hit(const TrianglePair& pair) const {
  return is_hit(triangle_a(pair.a), triangle_b(pair.b));
}

/// Calls `on_hit` for each hit until it returns false.
template <typename OnHit>
void MeshReferee::for_each_hit(const OnHit& on_hit) const {
  BoxTree::for_each_placed_overlap(
      a_.tree(), a_.pose(), b_.tree(), b_.pose(), [&](std::uint32_t a, std::uint32_t b) {
        const Triangle t_a = triangle_a(a);
        const Triangle t_b = triangle_b(b);
        return !share_a_box(t_a, t_b) || !is_hit(t_a, t_b) || on_hit(TrianglePair{a, b});
      });
}

std::optional<TrianglePair> MeshReferee::find_hit() const {
  std::optional<TrianglePair> hit;
  for_each_hit([&](const TrianglePair& pair) {
    hit = pair;
    return false;
  });
  return hit;
}

std::vector<TrianglePair> MeshReferee::find_hits() const {
  std::vector<TrianglePair> hits;
  for_each_hit([&](const TrianglePair& pair) {
    hits.push_back(pair);
    return true;
  });
  std::sort(hits.begin(), hits.end());
  return hits;
}

MeshReferee::Gap MeshReferee::find_gap(const std::optional<TrianglePair>& hint) const {
  const BoxTree tree_a(triangles_a());
  const BoxTree tree_b(triangles_b());
  std::optional<TrianglePair> hit;
  BoxTree::for_each_overlap(tree_a, tree_b, [&](std::uint32_t a, std::uint32_t b) {
    if (is_hit(TrianglePair{a, b})) hit = {a, b};
    return !hit;
  });
  if (hit) return {0, *hit};
  Gap best{0, hint.value_or(TrianglePair{0, 0})};
  const auto square_of = [&](std::uint32_t a, std::uint32_t b) {
    return squared_distance(exactly(triangle_a(a)), exactly(triangle_b(b)));
  };
  // The bound is above the root, so that no nearer pair is skipped.
  const auto bound_of = [](const mpq_class& square) {
    return rounded_root(square) * (1 + 0x1p-50);
  };
  best.square = square_of(best.pair.a, best.pair.b);
  // Most pairs lie behind each other along the offset between the nearest so far.
  const auto offset_of = [&](const TrianglePair& pair) -> Eigen::Vector3d {
    const TriangleDistance proposed = distance(triangle_a(pair.a), triangle_b(pair.b));
    return proposed.point_b - proposed.point_a;
  };
  Eigen::Vector3d offset = offset_of(best.pair);
  double bound = bound_of(best.square);
  BoxTree::for_each_nearer(tree_a, tree_b, bound, [&](std::uint32_t a, std::uint32_t b) {
    if (lies_surely_beyond(triangle_a(a), triangle_b(b), offset, bound)) return bound;
    const mpq_class square = square_of(a, b);
    if (square < best.square) {
      best = {square, {a, b}};
      offset = offset_of(best.pair);
      bound = bound_of(square);
    }
    return bound;
  });
  return best;
}

}  // namespace graze::compare
