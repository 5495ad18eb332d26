#include <graze/narrowphase/convex/hull.h>
#include <graze/narrowphase/predicates.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace graze::narrowphase {
namespace {

using Index = std::uint32_t;
using Corners = std::array<Index, 3>;  // counter-clockwise from outside

// Triangles whose normals are as close as this lie in one face: far above rounding, far below what
// anybody models.
constexpr double kOneFace = 1 - 1e-10;

const double* data(const Vec3& v) {
  return &v.x;
}

Sign side(const std::vector<Vec3>& p, const Corners& t, Index other) {
  return orientation_3d(data(p[t[0]]), data(p[t[1]]), data(p[t[2]]), data(p[other]));
}

bool are_equal(const Vec3& a, const Vec3& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

/// Exact: three points are on a line if they are so in all three projections.
bool are_on_a_line(const Vec3& a, const Vec3& b, const Vec3& c) {
  for (int axis = 0; axis < 3; ++axis) {
    if (orientation_2d(project(data(a), axis), project(data(b), axis), project(data(c), axis)) !=
        Sign::Zero) {
      return false;
    }
  }
  return true;
}

/// Four points with a volume, the first three counter-clockwise from outside.
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

/// Replaces the triangles that see the point by a fan from their horizon.
void add_point(const std::vector<Vec3>& p, Index point, std::vector<Corners>& triangles) {
  std::map<std::pair<Index, Index>, int> edges;  // directed, of triangles that see the point
  std::vector<Corners> kept;
  for (const Corners& t : triangles) {
    if (side(p, t, point) != Sign::Positive) {
      kept.push_back(t);
      continue;
    }
    for (int k = 0; k < 3; ++k)
      edges[{t[k], t[(k + 1) % 3]}] = 1;
  }
  if (edges.empty()) return;
  for (const auto& [edge, unused] : edges) {
    if (!edges.contains({edge.second, edge.first})) {
      kept.push_back({edge.first, edge.second, point});
    }
  }
  triangles = std::move(kept);
}

Vec3 normal_of(const std::vector<Vec3>& p, const Corners& t) {
  // Each edge by itself is scaled, so that thin and small triangles have their normals too.
  const Vec3 u = unit_or(p[t[1]] - p[t[0]], {1, 0, 0});
  const Vec3 v = unit_or(p[t[2]] - p[t[0]], {0, 1, 0});
  return unit_or(cross(u, v), {0, 0, 1});
}

/// Corners go relative to the middle of their box, so that a hull far from its frame's origin loses
/// nothing more.
void centre(Hull& hull) {
  Vec3 low = hull.corners[0];
  Vec3 high = hull.corners[0];
  for (const Vec3& c : hull.corners) {
    low = {std::min(low.x, c.x), std::min(low.y, c.y), std::min(low.z, c.z)};
    high = {std::max(high.x, c.x), std::max(high.y, c.y), std::max(high.z, c.z)};
  }
  hull.middle = low * 0.5 + high * 0.5;
  for (Vec3& c : hull.corners) {
    c = c - hull.middle;
    hull.reach = std::max(hull.reach, length(c));
  }
}

/// Gathers triangles that lie in one plane with the first of them, and chains the edges that only
/// one of them has.
class FaceBuilder {
 public:
  explicit FaceBuilder(const std::vector<Corners>& triangles)
      : triangles_(triangles), is_taken_(triangles.size(), false) {
    for (Index i = 0; i < triangles.size(); ++i) {
      for (int k = 0; k < 3; ++k)
        owner_[{triangles[i][k], triangles[i][(k + 1) % 3]}] = i;
    }
  }

  bool is_taken(Index triangle) const { return is_taken_[triangle]; }

  /// The corners around those connected to `first` for which `is_one_face(first, other)`.
  template <typename IsOneFace>
  std::vector<Index> loop_from(Index first, IsOneFace&& is_one_face) {
    std::vector<Index> open{first};
    std::map<Index, Index> next;  // along the boundary
    std::vector<Index> members;
    is_taken_[first] = true;
    while (!open.empty()) {
      const Index i = open.back();
      open.pop_back();
      members.push_back(i);
      for (int k = 0; k < 3; ++k) {
        const Index twin = owner_.at({triangles_[i][(k + 1) % 3], triangles_[i][k]});
        if (is_taken_[twin] || !is_one_face(first, twin)) continue;
        is_taken_[twin] = true;
        open.push_back(twin);
      }
    }
    std::sort(members.begin(), members.end());
    for (const Index i : members) {
      for (int k = 0; k < 3; ++k) {
        const Index from = triangles_[i][k], to = triangles_[i][(k + 1) % 3];
        if (!std::binary_search(members.begin(), members.end(), owner_.at({to, from}))) {
          next[from] = to;
        }
      }
    }
    std::vector<Index> loop;
    for (Index at = next.begin()->first; loop.size() < next.size(); at = next.at(at))
      loop.push_back(at);
    return loop;
  }

 private:
  const std::vector<Corners>& triangles_;
  std::vector<bool> is_taken_;
  std::map<std::pair<Index, Index>, Index> owner_;
};

/// The corners that lie in three planes of faces at least, exactly: points that others were added
/// around later may have come to lie within edges and faces.
std::map<Index, Index> true_corners(const std::vector<Vec3>& p,
                                    const std::vector<Corners>& triangles) {
  FaceBuilder builder(triangles);
  std::map<Index, Index> planes;
  for (Index i = 0; i < triangles.size(); ++i) {
    if (builder.is_taken(i)) continue;
    const std::vector<Index> loop = builder.loop_from(i, [&](Index first, Index other) {
      return std::all_of(triangles[other].begin(), triangles[other].end(), [&](Index corner) {
        return side(p, triangles[first], corner) == Sign::Zero;
      });
    });
    for (const Index corner : loop)
      ++planes[corner];
  }
  std::erase_if(planes, [](const auto& entry) { return entry.second < 3; });
  return planes;
}

/// Neighbours whose normals are one, but for rounding, are one face.
void add_faces(const std::vector<Vec3>& p, const std::vector<Corners>& triangles,
               const std::map<Index, Index>& renamed, Hull& hull) {
  std::vector<Vec3> normals;
  normals.reserve(triangles.size());
  for (const Corners& t : triangles)
    normals.push_back(normal_of(p, t));
  FaceBuilder builder(triangles);
  for (Index i = 0; i < triangles.size(); ++i) {
    if (builder.is_taken(i)) continue;
    const std::vector<Index> loop = builder.loop_from(i, [&](Index first, Index other) {
      return dot(normals[first], normals[other]) >= kOneFace;
    });
    const auto begin = static_cast<Index>(hull.loops.size());
    for (const Index corner : loop) {
      const auto found = renamed.find(corner);
      if (found != renamed.end()) hull.loops.push_back(found->second);
    }
    hull.faces.push_back({normals[i], begin, static_cast<Index>(hull.loops.size()) - begin});
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
  std::map<Index, Index> renamed = true_corners(points, triangles);
  for (auto& [from, to] : renamed) {
    to = static_cast<Index>(hull.corners.size());
    hull.corners.push_back(points[from]);
  }
  centre(hull);
  add_faces(points, triangles, renamed, hull);
  return HullDefect::None;
}

}  // namespace graze::narrowphase
