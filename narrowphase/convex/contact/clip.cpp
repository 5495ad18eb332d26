#include <graze/narrowphase/convex/contact/clip.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::narrowphase {
namespace {

struct Plane {
  Vec3 on;
  Vec3 out;  ///< the direction out of the face, of any length
};

/// Says where a plane cuts a polygon: along the line in which it meets the polygon's own plane.
struct FaceCut {
  Vec3 direction;  ///< the direction of that line, of any length
  double from = std::numeric_limits<double>::infinity();  ///< the least of `direction` . point
  double to = -std::numeric_limits<double>::infinity();   ///< the greatest of `direction` . point

  FaceCut(const ClippedFace& face, const double* height, const Vec3& along) : direction(along) {
    for (int i = 0; i < face.count; ++i) {
      const int next = i + 1 == face.count ? 0 : i + 1;
      if ((height[i] > 0) == (height[next] > 0)) continue;
      const double at = dot(face.corner[i].point, direction);
      const double run = dot(face.corner[next].point, direction) - at;
      const double found = at + run * (height[i] / (height[i] - height[next]));
      from = std::min(from, found), to = std::max(to, found);
    }
  }
  Vec3 nearest(const Vec3& point) const {
    const double at = dot(point, direction);
    if (at >= from && at <= to) return point;
    return point + direction * (((at < from ? from : to) - at) / dot(direction, direction));
  }
};

/// Edges that lie in the plane, to `within`, are not cut by it: their corners count as on it. Those
/// in front of it slide onto it, along the face. What is not behind it by more stays as it is.
void lay_edges(ClippedFace& face, const Vec3& normal, const Plane& plane, double within,
               bool is_closed, double (&height)[ClippedFace::kMostCorners]) {
  const int n = face.count;
  const Vec3 along = plane.out - normal * dot(plane.out, normal);
  const double fall = dot(plane.out, along);
  const double square = dot(plane.out, plane.out);
  const double limit = within * std::sqrt(square);
  const auto is_level = [&](int i) { return std::abs(height[i]) <= limit; };
  if (!(fall > 0.25 * square) || !(*std::min_element(height, height + n) < -limit)) return;
  bool lies[ClippedFace::kMostCorners] = {};
  for (int i = 0; i + (is_closed ? 0 : 1) < n; ++i) {
    const int next = i + 1 == n ? 0 : i + 1;
    if (is_level(i) && is_level(next)) lies[i] = lies[next] = true;
  }
  const auto sticks_out = [&](int i) { return lies[i] && height[i] > 0; };
  int first = 0;
  while (first < n && !sticks_out(first))
    ++first;
  if (first < n) {
    const FaceCut line(face, height, cross(normal, plane.out));
    for (int i = first; i < n; ++i) {
      Vec3& point = face.corner[i].point;
      if (sticks_out(i)) point = line.nearest(point - along * (height[i] / fall));
    }
  }
  for (int i = 0; i < n; ++i) {
    if (lies[i]) height[i] = 0, face.has_laid_edges = true;
  }
}

/// Puts the part that is not in front of the plane into `kept`, which is another face. False if
/// that is all of the face, and then `kept` says nothing.
bool cut(ClippedFace& face, const Vec3& normal, const Plane& plane, std::uint32_t edge,
         double within, bool is_closed, ClippedFace& kept) {
  const int n = face.count;
  double height[ClippedFace::kMostCorners];
  const auto is_cut = [&] {
    return std::any_of(height, height + n, [](double h) { return !(h <= 0); });
  };
  for (int i = 0; i < n; ++i)
    height[i] = dot(face.corner[i].point - plane.on, plane.out);
  if (!is_cut()) return false;
  lay_edges(face, normal, plane, within, is_closed, height);
  if (!is_cut()) return false;
  kept.count = 0;
  kept.has_laid_edges = face.has_laid_edges;
  const auto keep = [&](const ClippedFace::Corner& corner) {
    if (kept.count < ClippedFace::kMostCorners) kept.corner[kept.count++] = corner;
  };
  for (int i = 0; i < n; ++i) {
    const ClippedFace::Corner& from = face.corner[i];
    const int next = i + 1 == n ? 0 : i + 1;
    const ClippedFace::Corner& to = face.corner[next];
    if (height[i] <= 0) keep(from);
    if (i + 1 == n && !is_closed) break;  // a segment has no edge back to its start
    if ((height[i] < 0 && height[next] > 0) || (height[i] > 0 && height[next] < 0)) {
      const double share = height[i] / (height[i] - height[next]);
      const std::uint32_t own = ClippedFace::kEdge + (from.own & (ClippedFace::kEdge - 1));
      keep({from.point + (to.point - from.point) * share, own, edge});
    }
  }
  return true;
}

}  // namespace

ClippedFace clip(const ContactFace& face, const ContactFace& sides, const Vec3& direction,
                 double within) {
  ClippedFace faces[2];
  int now = 0;
  for (int i = 0; i < face.count; ++i)
    faces[0].corner[faces[0].count++] = {face.corner[i], face.corner_id[i], 0};
  const bool is_closed = face.count > 2;
  for (int i = 0; i < sides.count && sides.count > 1 && faces[now].count > 0; ++i) {
    const Vec3& from = sides.corner[i];
    const Vec3 edge = sides.corner[i + 1 == sides.count ? 0 : i + 1] - from;
    const Vec3 out =
        sides.count == 2 ? direction * dot(edge, direction) - edge : cross(edge, direction);
    if (cut(faces[now], face.normal, {from, out}, ClippedFace::kEdge + sides.corner_id[i], within,
            is_closed, faces[1 - now])) {
      now = 1 - now;
    }
  }
  ClippedFace clipped;
  clipped.count = faces[now].count;
  clipped.has_laid_edges = faces[now].has_laid_edges;
  std::copy(faces[now].corner, faces[now].corner + clipped.count, clipped.corner);
  return clipped;
}

bool is_sharp(const ContactFace& face) {
  // A point that is off edges by 2^-46 of the scale lies past a corner of this angle by 2^-34 of it
  // at most.
  constexpr double kSharp = 0x1p-12;
  if (face.count < 3) return false;
  Vec3 before = face.corner[0] - face.corner[face.count - 1];
  for (int i = 0; i < face.count; ++i) {
    const Vec3 after = face.corner[i + 1 == face.count ? 0 : i + 1] - face.corner[i];
    if (dot(before, after) < 0 &&
        length(cross(before, after)) < kSharp * length(before) * length(after)) {
      return true;
    }
    before = after;
  }
  return false;
}

std::optional<Vec3> on_nearest_edge(const ContactFace& face, const Vec3& point,
                                    const Vec3& direction, double slack) {
  const auto seen = [&](const Vec3& v) { return v - direction * dot(v, direction); };
  bool is_within = true;
  Vec3 nearest = point;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < face.count; ++i) {
    const Vec3& corner = face.corner[i];
    const Vec3 whole_edge = face.corner[i + 1 == face.count ? 0 : i + 1] - corner;
    const Vec3 edge = seen(whole_edge), offset = seen(point - corner);
    const Vec3 out = cross(edge, face.normal);
    if (!(dot(offset, out) < -slack * length(out))) is_within = false;
    const double square = dot(edge, edge);
    const double share = square > 0 ? std::clamp(dot(offset, edge) / square, 0.0, 1.0) : 0;
    const Vec3 apart = edge * share - offset;
    if (dot(apart, apart) < least) least = dot(apart, apart), nearest = corner + whole_edge * share;
  }
  return is_within ? std::nullopt : std::optional(nearest);
}

}  // namespace graze::narrowphase
