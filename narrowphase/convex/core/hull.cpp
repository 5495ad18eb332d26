#include <graze/narrowphase/convex/core/contact_faces.h>
#include <graze/narrowphase/convex/core/hull.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/ray/ray_stages.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace graze::narrowphase {
namespace {

using Index = std::uint32_t;
using Corners = std::array<Index, 3>;  // counter-clockwise from outside

const double* data(const Vec3& v) {
  return &v.x;
}

Sign side(const std::vector<Vec3>& p, const Corners& t, Index other) {
  return orientation_3d(data(p[t[0]]), data(p[t[1]]), data(p[t[2]]), data(p[other]));
}

bool are_equal(const Vec3& a, const Vec3& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

/// Tells exactly whether three points are on a line: they are if they are so in all three
/// projections.
bool are_on_a_line(const Vec3& a, const Vec3& b, const Vec3& c) {
  for (int axis = 0; axis < 3; ++axis) {
    if (orientation_2d(project(data(a), axis), project(data(b), axis), project(data(c), axis)) !=
        Sign::Zero) {
      return false;
    }
  }
  return true;
}

/// Finds four points with a volume, the first three counter-clockwise from outside.
HullDefect first_tetrahedron(const std::vector<Vec3>& p, std::array<Index, 4>& t) {
  const Index n = static_cast<Index>(p.size());
  t = {0, 0, 0, 0};
  const auto find = [&](int k, auto&& is_wanted) {
    for (Index i = 0; i < n && t[k] == 0; ++i) {
      if (is_wanted(i)) t[k] = i;
    }
    return t[k] != 0;
  };
  if (!find(1, [&](Index i) { return !are_equal(p[0], p[i]); })) return HullDefect::Point;
  if (!find(2, [&](Index i) { return !are_on_a_line(p[0], p[t[1]], p[i]); })) {
    return HullDefect::Line;
  }
  const Corners base{t[0], t[1], t[2]};
  if (!find(3, [&](Index i) { return side(p, base, i) != Sign::Zero; })) return HullDefect::Plane;
  if (side(p, base, t[3]) == Sign::Positive) std::swap(t[1], t[2]);
  return HullDefect::None;
}

/// Replaces the triangles that the point is not behind by a fan from their horizon. Those in whose
/// planes it lies go too, so that no new triangle is without area: an edge of the horizon belongs
/// to a triangle that the point is strictly behind, and so it is on no line with that edge. They
/// hang together with those that see it, and around a corner the planes in front of the point
/// follow each other: the horizon is one closed loop. What lies within a face or an edge thus drops
/// out.
void add_point(const std::vector<Vec3>& p, Index point, std::vector<Corners>& triangles) {
  std::vector<Sign> sides;
  sides.reserve(triangles.size());
  for (const Corners& t : triangles)
    sides.push_back(side(p, t, point));
  if (std::find(sides.begin(), sides.end(), Sign::Positive) == sides.end()) return;
  std::set<std::pair<Index, Index>> edges;  // directed, of those that go
  std::vector<Corners> kept;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Corners& t = triangles[i];
    if (sides[i] == Sign::Negative) {
      kept.push_back(t);
      continue;
    }
    for (int k = 0; k < 3; ++k)
      edges.insert({t[k], t[(k + 1) % 3]});
  }
  for (const auto& [from, to] : edges) {
    if (!edges.contains({to, from})) kept.push_back({from, to, point});
  }
  triangles = std::move(kept);
}

/// Moves corners so that they are relative to the middle of their box, and a hull far from its
/// frame's origin loses nothing more.
void centre(Hull& hull) {
  Vec3 low = hull.exact_corners[0];
  Vec3 high = low;
  for (const Vec3& c : hull.exact_corners) {
    low = {std::min(low.x, c.x), std::min(low.y, c.y), std::min(low.z, c.z)};
    high = {std::max(high.x, c.x), std::max(high.y, c.y), std::max(high.z, c.z)};
  }
  hull.middle = low * 0.5 + high * 0.5;
  for (const Vec3& c : hull.exact_corners) {
    hull.corners.push_back(c - hull.middle);
    hull.bounding_radius = std::max(hull.bounding_radius, length(hull.corners.back()));
  }
}

/// Gathers triangles that lie in one plane, and chains the edges that only one of them has.
class FaceBuilder {
 public:
  FaceBuilder(const std::vector<Vec3>& points, const std::vector<Corners>& triangles)
      : points_(points), triangles_(triangles), is_taken_(triangles.size(), false) {
    for (Index i = 0; i < triangles.size(); ++i) {
      for (int k = 0; k < 3; ++k)
        face_of_[{triangles[i][k], triangles[i][(k + 1) % 3]}] = i;
    }
  }

  bool is_taken(Index triangle) const { return is_taken_[triangle]; }

  /// Returns the corners around all triangles in the plane of `first`.
  std::vector<Index> loop_from(Index first) {
    std::vector<Index> open{first};
    std::map<Index, Index> next;  // along the boundary
    is_taken_[first] = true;
    while (!open.empty()) {
      const Corners& t = triangles_[open.back()];
      open.pop_back();
      for (int k = 0; k < 3; ++k) {
        const Index from = t[k], to = t[(k + 1) % 3];
        const Index twin = face_of_.at({to, from});
        if (!is_in_plane(first, twin)) {
          next[from] = to;
        } else if (!is_taken_[twin]) {
          is_taken_[twin] = true;
          open.push_back(twin);
        }
      }
    }
    std::vector<Index> loop;
    for (Index at = next.begin()->first; loop.size() < next.size(); at = next.at(at))
      loop.push_back(at);
    return loop;
  }

 private:
  bool is_in_plane(Index first, Index other) const {
    const Corners& t = triangles_[other];
    return std::all_of(t.begin(), t.end(), [&](Index corner) {
      return side(points_, triangles_[first], corner) == Sign::Zero;
    });
  }

  const std::vector<Vec3>& points_;
  const std::vector<Corners>& triangles_;
  std::vector<bool> is_taken_;
  std::map<std::pair<Index, Index>, Index> face_of_;
};

/// Returns the unit normal of a face, from three of its corners that are apart: no three are on a
/// line.
Vec3 normal_of(const std::vector<Vec3>& p, const std::vector<Index>& loop) {
  const std::size_t n = loop.size();
  const auto at = [&](std::size_t i) {
    const Vec3& c = p[loop[i]];
    return Eigen::Vector3d(c.x, c.y, c.z);
  };
  const Eigen::Vector3d normal = unit_normal(Triangle{at(0), at(n / 3), at(2 * n / 3)});
  return {normal.data()[0], normal.data()[1], normal.data()[2]};
}

/// Notes which face each edge leads to.
void add_neighbours(Hull& hull) {
  std::map<std::pair<Index, Index>, Index> face_of;
  const auto edge = [&](const Hull::Face& face, Index i) {
    const Index next = i + 1 == face.count ? 0 : i + 1;
    return std::pair(hull.loops[face.first + i], hull.loops[face.first + next]);
  };
  for (Index f = 0; f < hull.faces.size(); ++f) {
    for (Index i = 0; i < hull.faces[f].count; ++i)
      face_of[edge(hull.faces[f], i)] = f;
  }
  for (const Hull::Face& face : hull.faces) {
    for (Index i = 0; i < face.count; ++i) {
      const auto [from, to] = edge(face, i);
      hull.beyond.push_back(face_of.at({to, from}));
    }
  }
}

void add_faces(const std::vector<Vec3>& p, const std::vector<Corners>& triangles,
               const std::map<Index, Index>& renamed, Hull& hull) {
  FaceBuilder builder(p, triangles);
  for (Index i = 0; i < triangles.size(); ++i) {
    if (builder.is_taken(i)) continue;
    const std::vector<Index> loop = builder.loop_from(i);
    const auto begin = static_cast<Index>(hull.loops.size());
    for (const Index corner : loop)
      hull.loops.push_back(renamed.at(corner));
    hull.faces.push_back({normal_of(p, loop), begin, static_cast<Index>(loop.size())});
  }
}

}  // namespace

HullDefect build_hull(const std::vector<Vec3>& points, Hull& hull) {
  std::array<Index, 4> t{};
  const HullDefect defect = first_tetrahedron(points, t);
  if (defect != HullDefect::None) return defect;
  std::vector<Corners> triangles{
      {t[0], t[1], t[2]}, {t[0], t[3], t[1]}, {t[1], t[3], t[2]}, {t[2], t[3], t[0]}};
  for (Index i = 0; i < points.size(); ++i)
    add_point(points, i, triangles);
  std::sort(triangles.begin(), triangles.end());

  hull = {};
  std::map<Index, Index> renamed;
  for (const Corners& triangle : triangles) {
    for (const Index corner : triangle)
      renamed[corner] = 0;
  }
  for (auto& [from, to] : renamed) {
    to = static_cast<Index>(hull.exact_corners.size());
    hull.exact_corners.push_back(points[from]);
  }
  centre(hull);
  add_faces(points, triangles, renamed, hull);
  add_neighbours(hull);
  for (const Hull::Face& face : hull.faces)
    hull.offsets.push_back(dot(face.normal, hull.corners[hull.loops[face.first]]));
  add_contact_faces(hull);
  return HullDefect::None;
}

}  // namespace graze::narrowphase
