#include <graze/engine/compare/judge/rational/mesh_referee.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>
#include <graze/engine/compare/referee.h>
#include <graze/engine/mesh/placement.h>

#include <algorithm>
#include <limits>

namespace graze::compare {
namespace {

std::vector<Triangle> placed_triangles(const PlacedMeshView& mesh) {
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.mesh.triangles().size());
  for (std::size_t i = 0; i < mesh.mesh.triangles().size(); ++i)
    triangles.push_back(place(mesh.pose, mesh.mesh.triangle(i)));
  return triangles;
}

}  // namespace

MeshReferee::MeshReferee(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b, Touch touch)
    : touch_(touch),
      triangles_a_(placed_triangles(mesh_a)),
      triangles_b_(placed_triangles(mesh_b)),
      tree_a_(triangles_a_),
      tree_b_(triangles_b_) {}

bool MeshReferee::is_hit(const TrianglePair& pair) const {
  const Triangle& a = triangles_a_[pair.a];
  const Triangle& b = triangles_b_[pair.b];
  if (!referee_intersects(a, b)) return false;
  return touch_ == Touch::Include || do_cross(exactly(a), exactly(b));
}

std::optional<TrianglePair> MeshReferee::find_hit() const {
  std::optional<TrianglePair> hit;
  BoxTree::for_each_overlap(tree_a_, tree_b_, [&](std::uint32_t a, std::uint32_t b) {
    if (is_hit({a, b})) hit = {a, b};
    return !hit;
  });
  return hit;
}

std::vector<TrianglePair> MeshReferee::find_hits() const {
  std::vector<TrianglePair> hits;
  BoxTree::for_each_overlap(tree_a_, tree_b_, [&](std::uint32_t a, std::uint32_t b) {
    if (is_hit({a, b})) hits.push_back({a, b});
    return true;
  });
  std::sort(hits.begin(), hits.end());
  return hits;
}

MeshReferee::Gap MeshReferee::find_gap(const std::optional<TrianglePair>& hint) const {
  if (const std::optional<TrianglePair> hit = find_hit()) return {0, *hit};
  Gap best{0, hint.value_or(TrianglePair{0, 0})};
  const auto square_of = [&](std::uint32_t a, std::uint32_t b) {
    return squared_distance(exactly(triangles_a_[a]), exactly(triangles_b_[b]));
  };
  // A bound above the root, so that no nearer pair is passed over.
  const auto bound_of = [](const mpq_class& square) {
    return rounded_root(square) * (1 + 0x1p-50);
  };
  best.square = square_of(best.pair.a, best.pair.b);
  BoxTree::for_each_nearer(tree_a_, tree_b_, bound_of(best.square),
                           [&](std::uint32_t a, std::uint32_t b) {
                             const mpq_class square = square_of(a, b);
                             if (square < best.square) best = {square, {a, b}};
                             return bound_of(best.square);
                           });
  return best;
}

}  // namespace graze::compare
