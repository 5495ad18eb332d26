#include <graze/engine/mesh/data/mesh_patch.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/data/patch_rim.h>
#include <graze/engine/mesh/data/vertex_fans.h>
#include <graze/engine/world/contacts/meshes/inner_surface.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace graze {

using narrowphase::Core;
using narrowphase::Vec3;
using Mark = VertexMarks::Mark;

namespace {

// Heights of ends of crossings over a part's origin are off by less than this share of the largest
// coordinate: two heights of three products each by 2^-49 of it. A part may be smaller than that
// by far.
constexpr double kRounding = 0x1p-48;

}  // namespace

void VertexMarks::start(std::size_t vertices) {
  if (marks_.size() < vertices) marks_.resize(vertices, 0);
  if (round_ > std::numeric_limits<std::uint32_t>::max() - 8) {
    std::fill(marks_.begin(), marks_.end(), 0);
    round_ = 0;
  }
  round_ += 4;
}

void InnerPart::clear() {
  points.clear(), vertex.clear(), is_outer.clear(), is_opened.clear();
  rows_.clear();
  radius = square_radius_ = 0;
}

void InnerPart::add(const Vec3& point, std::uint32_t of_vertex, bool is_outside) {
  points.push_back(point), vertex.push_back(of_vertex);
  is_outer.push_back(is_outside), is_opened.push_back(false);
  rows_.add(point);
  const double square = dot(point, point);
  if (square > square_radius_) square_radius_ = square, radius = std::sqrt(square);
}

void InnerPart::shorten(std::size_t count, double to_radius) {
  points.resize(count), vertex.resize(count);
  is_outer.resize(count), is_opened.resize(count);
  rows_.resize(count);
  radius = to_radius, square_radius_ = radius * radius;
}

std::size_t InnerPart::farthest(const Vec3& direction) const {
  return rows_.farthest(direction, points.size());
}

std::size_t InnerPart::next_beyond(const Vec3& direction, double along, std::size_t from) const {
  return rows_.next_beyond(direction, along, from);
}

std::optional<double> InnerPart::outer_extent(const Vec3& direction, double depth) const {
  constexpr double kSame = 1e-6, kShallow = 1e-4;
  const std::size_t last = farthest(direction);
  if (!is_outer[last]) return 0;
  const double all = dot(points[last], direction);
  const double least = all - std::max(kSame * radius, std::min(0.05 * depth, kShallow * radius));
  std::optional<double> extent;
  for (std::size_t i = 0; (i = next_beyond(direction, least, i)) < points.size(); ++i) {
    if (is_outer[i]) continue;
    const double lacking = all - dot(points[i], direction);
    if (!extent || lacking < *extent) extent = lacking;
  }
  return extent;
}

Core InnerPart::core() const {
  Core core;
  core.kind = narrowphase::CoreKind::Points;
  core.at = at;
  core.points = points.data();
  core.point_count = points.size();
  core.rows = &rows_;
  core.bounding_radius = radius;
  return core;
}

void LoopGroups::start(std::uint32_t loops) {
  parent_.resize(loops);
  std::iota(parent_.begin(), parent_.end(), 0u);
}

std::uint32_t LoopGroups::root(std::uint32_t loop) {
  while (parent_[loop] != loop)
    loop = parent_[loop] = parent_[parent_[loop]];
  return loop;
}

void LoopGroups::join(std::uint32_t s, std::uint32_t t) {
  s = root(s), t = root(t);
  parent_[std::max(s, t)] = std::min(s, t);
}

void LoopGroups::number() {
  number_.resize(parent_.size());
  count_ = 0;
  for (std::uint32_t loop = 0; loop < parent_.size(); ++loop) {
    const std::uint32_t first = root(loop);
    number_[loop] = first == loop ? count_++ : number_[first];
  }
}

void InnerSurface::collect(const PlacedMeshView& mesh, const Vec3& origin, InnerSide side,
                           const MeshCrossings& found, LoopGroups& groups) {
  placing_ = placing_of(mesh, origin), side_ = side, welded_ = mesh.mesh.welded();
  is_rim_ = rim_of(mesh.mesh);
  marks_.start(mesh.mesh.vertices().size());
  loop_of_.resize(std::max(loop_of_.size(), mesh.mesh.vertices().size()));
  part_of_.resize(std::max(part_of_.size(), mesh.mesh.vertices().size()));
  passed_over_.resize(part_of_.size());
  collected_.clear();
  const std::vector<EdgeCrossing>& edges = side == InnerSide::OfA ? found.edges_a : found.edges_b;
  start(edges, groups);
  fans_ = &vertex_fans_of(mesh.mesh);
  for (std::size_t i = 0; i < collected_.size() && collected_.size() < kMostVertices; ++i) {
    const Collected of = collected_[i];
    note_rim(of.vertex);
    for (const std::uint32_t triangle : fans_->around(of.vertex)) {
      for (const std::uint32_t index : placing_.triangles[triangle]) {
        const std::uint32_t next = welded_[index];
        const Mark mark = marks_[next];
        if (mark == Mark::Inside && loop_of_[next] == of.loop) continue;
        if (mark == Mark::Outside || is_crossed(edges, of.vertex, next)) continue;
        note(next, true, of.loop, groups);
      }
    }
  }
}

/// True if the way along an edge leads outside, if only for a part of it.
bool InnerSurface::is_crossed(const std::vector<EdgeCrossing>& edges, std::uint32_t s,
                              std::uint32_t t) {
  const std::uint64_t ends = std::uint64_t{std::min(s, t)} << 32 | std::max(s, t);
  const auto ends_of = [](const EdgeCrossing& edge) {
    return std::uint64_t{edge.low} << 32 | edge.high;
  };
  const auto at = std::lower_bound(
      edges.begin(), edges.end(), ends,
      [&](const EdgeCrossing& edge, std::uint64_t value) { return ends_of(edge) < value; });
  return at != edges.end() && ends_of(*at) == ends;
}

void InnerSurface::start(const std::vector<EdgeCrossing>& edges, LoopGroups& groups) {
  const auto is_same = [&](std::size_t i, std::size_t j) {
    return edges[i].low == edges[j].low && edges[i].high == edges[j].high;
  };
  // What of an edge lies inside between two crossings connects their loops.
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (is_same(i, i - 1) && edges[i - 1].is_entry && !edges[i].is_entry)
      groups.join(edges[i - 1].loop, edges[i].loop);
  }
  // Vertices that are outside by any crossing are marked before those that are inside by another.
  for (const bool takes_inside : {false, true}) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const EdgeCrossing& edge = edges[i];
      const bool is_first = i == 0 || !is_same(i, i - 1);
      const bool is_last = i + 1 == edges.size() || !is_same(i, i + 1);
      if (is_first && edge.is_entry != takes_inside)
        note(edge.low, takes_inside, edge.loop, groups);
      if (is_last && edge.is_entry == takes_inside)
        note(edge.high, takes_inside, edge.loop, groups);
    }
  }
}

void InnerSurface::note(std::uint32_t vertex, bool is_inside, std::uint32_t loop,
                        LoopGroups& groups) {
  if (marks_[vertex] == Mark::Inside && is_inside) return groups.join(loop_of_[vertex], loop);
  if (marks_[vertex] != Mark::None) return;
  marks_.set(vertex, is_inside ? Mark::Inside : Mark::Outside);
  loop_of_[vertex] = loop;
  if (is_inside) collected_.push_back({vertex, loop});
}

void InnerSurface::build(const MeshCrossings& found, const LoopGroups& groups) {
  first_part_ += parts_.size() + 1;
  entered_ = kNoPiece;
  crossings_ = found.crossings;
  if (parts_.size() < groups.count()) parts_.resize(groups.count());
  for (std::uint32_t piece = 0; piece < groups.count(); ++piece)
    parts_[piece].clear();
  std::uint32_t points = 0;
  for (std::uint32_t i = 0; i < crossings_.size(); ++i) {
    const MeshCrossing& crossing = crossings_[i];
    InnerPart& part = parts_[crossing.piece];
    if (part.points.empty()) part.at = crossing.from, part.first_crossing = i;
    part.crossing_count = i + 1 - part.first_crossing;
    // A point in which another crossing ended is there already.
    if (crossing.from_number == points)
      ++points, part.add(crossing.from - part.at, InnerPart::kNoVertex, false);
    if (crossing.to_number == points)
      ++points, part.add(crossing.to - part.at, InnerPart::kNoVertex, false);
  }
  for (const Collected& each : collected_) {
    InnerPart& part = parts_[groups.group(each.loop)];
    part.add(placed(each.vertex) - part.at, each.vertex, false);
    // All its neighbours are there, or beyond a curve.
    part.is_opened.back() = collected_.size() < kMostVertices;
  }
}

/// Marks the points of a piece as its own. Parts may share vertices that lie beyond them.
void InnerSurface::enter(std::uint32_t piece) {
  if (entered_ == piece) return;
  entered_ = piece;
  const InnerPart& part = parts_[piece];
  lasting_ = part.points.size(), lasting_radius_ = part.radius;
  for (const std::uint32_t vertex : part.vertex)
    if (vertex != InnerPart::kNoVertex) part_of_[vertex] = first_part_ + piece;
}

/// Adds the corners of a triangle that lie higher than `above` in a direction.
void InnerSurface::add_corners(std::uint32_t piece, std::uint32_t triangle, bool is_outside,
                               const Vec3& direction, double above) {
  InnerPart& part = parts_[piece];
  for (const std::uint32_t index : placing_.triangles[triangle]) {
    const std::uint32_t vertex = welded_[index];
    if (part_of_[vertex] == first_part_ + piece || passed_over_[vertex] == climb_) continue;
    const Vec3 point = placed(vertex) - part.at;
    if (!(dot(point, direction) > above)) {
      passed_over_[vertex] = climb_;
      continue;
    }
    part_of_[vertex] = first_part_ + piece;
    part.add(point, vertex, this->is_outside(vertex, is_outside));
  }
}

/// Adds the vertices around a vertex that lie farther in a direction.
void InnerSurface::open(std::uint32_t piece, std::size_t point, const Vec3& direction) {
  const InnerPart& part = parts_[piece];
  const double above = dot(part.points[point], direction);
  const bool is_outside = part.is_outer[point];
  note_rim(part.vertex[point]);
  for (const std::uint32_t triangle : fans_->around(part.vertex[point]))
    add_corners(piece, triangle, is_outside, direction, above);
}

/// Adds the outer corners of triangles that cross where a curve is as far as anything of the part.
void InnerSurface::open_curves(std::uint32_t piece, const Vec3& direction, double most) {
  const InnerPart& part = parts_[piece];
  ++climb_;
  const double same =
      std::max(kSameHeight * part.radius, kRounding * (largest(part.at) + part.radius));
  const double offset = dot(part.at, direction);
  for (const MeshCrossing& crossing : crossings_of(piece)) {
    const double end = std::max(dot(crossing.from, direction), dot(crossing.to, direction));
    if (end - offset < most - same) continue;
    const std::uint32_t triangle = side_ == InnerSide::OfA ? crossing.pair.a : crossing.pair.b;
    add_corners(piece, triangle, true, direction, most + same);
  }
}

std::size_t InnerSurface::grow(std::uint32_t piece, const Vec3& direction) {
  enter(piece);
  InnerPart& part = parts_[piece];
  std::size_t best = part.farthest(direction);
  double most = dot(part.points[best], direction);
  std::size_t looked_at = part.points.size();
  const auto take_best = [&] {
    for (; looked_at < part.points.size(); ++looked_at) {
      const double along = dot(part.points[looked_at], direction);
      if (along > most) most = along, best = looked_at;
    }
  };
  open_curves(piece, direction, most);
  take_best();
  constexpr std::size_t kNone = ~std::size_t{0};
  std::size_t opened = kNone;
  ++climb_;
  // A body that had to go round by as much as the part is wide does not leave it that way.
  const double enough = most + 2 * lasting_radius_;
  while (most < enough && best != opened && part.vertex[best] != InnerPart::kNoVertex &&
         !part.is_opened[best]) {
    open(piece, opened = best, direction);
    take_best();
  }
  return best;
}

void InnerSurface::shrink(std::uint32_t piece) {
  if (entered_ != piece) return;
  InnerPart& part = parts_[piece];
  if (part.points.size() == lasting_) return;
  for (std::size_t i = lasting_; i < part.points.size(); ++i)
    part_of_[part.vertex[i]] = 0;
  part.shorten(lasting_, lasting_radius_);
}

void InnerSurface::note_neighbours(std::uint32_t triangle) const {
  if (is_rim_.empty()) return;
  for (const std::uint32_t vertex : corners(triangle))
    note_rim(vertex);
}

/// Notes for PatchRim that the surroundings of a vertex are looked at.
void InnerSurface::note_rim(std::uint32_t vertex) const {
  if (!is_rim_.empty() && is_rim_[vertex] != 0) PatchRim::meet();
}

Vec3 InnerSurface::placed(std::uint32_t vertex) const {
  return placed_vertex(placing_, vertex);
}

std::array<std::uint32_t, 3> InnerSurface::corners(std::uint32_t triangle) const {
  const TriangleIndices& of = placing_.triangles[triangle];
  return {welded_[of[0]], welded_[of[1]], welded_[of[2]]};
}

std::span<const std::uint32_t> InnerSurface::around(std::uint32_t vertex) const {
  note_rim(vertex);
  return fans_->around(vertex);
}

}  // namespace graze
