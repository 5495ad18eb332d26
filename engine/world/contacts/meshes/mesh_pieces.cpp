#include <graze/engine/world/contacts/mesh_placing.h>
#include <graze/engine/world/contacts/meshes/mesh_pieces.h>
#include <graze/engine/world/contacts/meshes/triangle_axes.h>
#include <graze/engine/world/shapes/pair_input.h>

#include <algorithm>

namespace graze {

using narrowphase::Vec3;

Vec3 Outline::normal() const {
  constexpr double kFlat = 1e-4;
  return unit_or(length(area) > kFlat * around * around ? area : faces_a - faces_b, {});
}

double Outline::together(bool faces_are_a) const {
  return length(faces_are_a ? faces_a : faces_b) / around;
}

/// Finds the outline of each loop or piece, whose number for a crossing `number_of` returns.
template <typename NumberOf>
void MeshPieces::find_outlines(std::uint32_t count, NumberOf&& number_of) {
  outlines_.assign(count, {});
  for (const MeshCrossing& crossing : found_.crossings) {
    Outline& outline = outlines_[number_of(crossing)];
    const double segment = length(crossing.to - crossing.from);
    if (outline.around == 0) outline.first = crossing.from;
    outline.area =
        outline.area + cross(crossing.from - outline.first, crossing.to - outline.first) * 0.5;
    outline.faces_a = outline.faces_a + crossing.normal_a * segment;
    outline.faces_b = outline.faces_b + crossing.normal_b * segment;
    outline.around += segment;
  }
}

/// Joins each loop that bounds a hole with the largest loop of its piece: such a loop turns against
/// the others with which it shares triangles.
void MeshPieces::join_holes() {
  constexpr std::uint32_t kNone = 0xffffffffu;
  find_outlines(found_.loops, [](const MeshCrossing& each) { return each.loop; });
  const auto area = [&](std::uint32_t loop) { return length(outlines_[loop].area); };
  largest_loop_.assign(found_.pieces, kNone);
  for (const MeshCrossing& crossing : found_.crossings) {
    std::uint32_t& largest = largest_loop_[crossing.piece];
    if (largest == kNone || area(crossing.loop) > area(largest)) largest = crossing.loop;
  }
  for (const MeshCrossing& crossing : found_.crossings) {
    const std::uint32_t outer = largest_loop_[crossing.piece];
    if (dot(outlines_[crossing.loop].area, outlines_[outer].area) < 0)
      groups_.join(outer, crossing.loop);
  }
}

MeshPieces::Found MeshPieces::find(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                                   const Vec3& origin, Work& work) {
  mesh_a_ = &mesh_a, mesh_b_ = &mesh_b, origin_ = origin;
  const bool is_all = find_crossings(mesh_a, mesh_b, origin, found_, work);
  if (found_.pairs.empty()) return Found::Nothing;
  if (!is_all || found_.crossings.empty()) return Found::Touches;
  groups_.start(found_.loops);
  inner_a_.collect(mesh_a, origin, InnerSide::OfA, found_, groups_);
  inner_b_.collect(mesh_b, origin, InnerSide::OfB, found_, groups_);
  join_holes();
  groups_.number();
  for (MeshCrossing& crossing : found_.crossings)
    crossing.piece = groups_.group(crossing.loop);
  found_.pieces = groups_.count();
  std::sort(found_.crossings.begin(), found_.crossings.end(),
            [](const MeshCrossing& s, const MeshCrossing& t) {
              return s.piece != t.piece ? s.piece < t.piece : s.pair < t.pair;
            });
  numbers_.number(found_.crossings);
  ends_.assign(found_.pieces, 0);
  for (std::size_t i = 0; i < found_.crossings.size(); ++i)
    ends_[found_.crossings[i].piece] = i + 1;
  find_outlines(found_.pieces, [](const MeshCrossing& each) { return each.piece; });
  inner_a_.build(found_, groups_);
  inner_b_.build(found_, groups_);
  return Found::Pieces;
}

std::span<const MeshCrossing> MeshPieces::crossings(std::uint32_t piece) const {
  const std::size_t begin = piece == 0 ? 0 : ends_[piece - 1];
  return std::span(found_.crossings).subspan(begin, ends_[piece] - begin);
}

bool MeshPieces::is_left_one_way(std::uint32_t piece) const {
  constexpr double kAlong = 0.9994;  // the cosine of 2 degrees
  constexpr double kNearlyAll = 0.9;
  const Vec3 about = outlines_[piece].normal();
  Vec3 way = about;
  double nearest = 0;
  const auto offer = [&](const Vec3& normal) {
    if (dot(normal, about) > nearest) nearest = dot(normal, about), way = normal;
  };
  for (const MeshCrossing& crossing : crossings(piece))
    offer(crossing.normal_a), offer(-crossing.normal_b);
  double along = 0;
  for (const MeshCrossing& crossing : crossings(piece)) {
    if (dot(crossing.normal_a, way) > kAlong || -dot(crossing.normal_b, way) > kAlong)
      along += length(crossing.to - crossing.from);
  }
  return along > kNearlyAll * outlines_[piece].around;
}

double MeshPieces::larger() const {
  const auto size = [](const Mesh& mesh) {
    return (mesh.bounds().max - mesh.bounds().min).squaredNorm();
  };
  const double by_size = size(mesh_a_->mesh) - size(mesh_b_->mesh);
  if (by_size != 0) return by_size;
  return static_cast<double>(mesh_a_->mesh.triangles().size()) -
         static_cast<double>(mesh_b_->mesh.triangles().size());
}

double MeshPieces::size() {
  double size = 0;
  for (std::uint32_t piece = 0; piece < count(); ++piece) {
    const InnerPart &a = inner_a(piece), &b = inner_b(piece);
    size = std::max(size, length(a.at) + std::max(a.radius, b.radius));
  }
  return size;
}

namespace {

/// True if the triangle `other` is in front of the plane of the first. Mostly this parts two
/// triangles that are apart.
bool is_in_front(const Vec3 (&plane)[3], const Vec3 (&other)[3]) {
  const Vec3 normal = cross(plane[1] - plane[0], plane[2] - plane[0]);
  return dot(normal, other[0] - plane[0]) > 0 && dot(normal, other[1] - plane[0]) > 0 &&
         dot(normal, other[2] - plane[0]) > 0;
}

bool are_apart(const PlacedCorners& a, const PlacedCorners& b, Work& work) {
  if (is_in_front(b.corner, a.corner) || is_in_front(a.corner, b.corner)) return true;
  ++work.convex_tests;
  const SureVerdict verdict = decide_by_axes(a.corner, b.corner);
  if (verdict != SureVerdict::Unsure) return verdict == SureVerdict::Apart;
  PairStatus status{};
  return graze::are_apart(core_of(a), core_of(b), status);
}

}  // namespace

void MeshPieces::remove_apart(std::vector<TrianglePair>& pairs, const Vec3& translation,
                              Work& work) const {
  const MeshPlacing of_a = placing_of(*mesh_a_, origin_), of_b = placing_of(*mesh_b_, origin_);
  constexpr std::uint32_t kNone = 0xffffffffu;
  std::uint32_t placed = kNone;
  PlacedCorners a;
  std::erase_if(pairs, [&](const TrianglePair& pair) {
    if (placed != pair.a) {
      a = placed_corners(of_a, placed = pair.a);
      for (Vec3& corner : a.corner)
        corner = corner + translation;
    }
    return are_apart(a, placed_corners(of_b, pair.b), work);
  });
}

}  // namespace graze
