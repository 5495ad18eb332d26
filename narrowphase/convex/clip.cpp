#include <graze/narrowphase/convex/clip.h>

#include <algorithm>

namespace graze::narrowphase {
namespace {

/// Puts what is not in front of the plane through `on` with the outward normal `out` into `kept`,
/// which is another face. False if that is all of the face, and then `kept` says nothing.
bool cut(const ClippedFace& face, const Vec3& on, const Vec3& out, std::uint32_t edge,
         bool is_closed, ClippedFace& kept) {
  const int n = face.count;
  double height[ClippedFace::kMostCorners];
  bool is_cut = false;
  for (int i = 0; i < n; ++i) {
    height[i] = dot(face.corner[i].point - on, out);
    is_cut |= !(height[i] <= 0);
  }
  if (!is_cut) return false;
  kept.count = 0;
  const auto keep = [&](const ClippedFace::Corner& corner) {
    if (kept.count < ClippedFace::kMostCorners) kept.corner[kept.count++] = corner;
  };
  for (int i = 0; i < n; ++i) {
    const ClippedFace::Corner& from = face.corner[i];
    const int next = i + 1 == n ? 0 : i + 1;
    const ClippedFace::Corner& to = face.corner[next];
    if (height[i] <= 0) keep(from);
    if (i + 1 == n && !is_closed) break;  // a segment has no way back
    if ((height[i] < 0 && height[next] > 0) || (height[i] > 0 && height[next] < 0)) {
      const double share = height[i] / (height[i] - height[next]);
      const std::uint32_t own = ClippedFace::kEdge + (from.own & (ClippedFace::kEdge - 1));
      keep({from.point + (to.point - from.point) * share, own, edge});
    }
  }
  return true;
}

}  // namespace

ClippedFace clip(const ContactFace& face, const ContactFace& sides) {
  ClippedFace faces[2];
  int now = 0;
  for (int i = 0; i < face.count; ++i)
    faces[0].corner[faces[0].count++] = {face.corner[i], face.corner_id[i], 0};
  const bool is_closed = face.count > 2;
  for (int i = 0; i < sides.count && sides.count > 1 && faces[now].count > 0; ++i) {
    const Vec3& from = sides.corner[i];
    const Vec3 edge = sides.corner[i + 1 == sides.count ? 0 : i + 1] - from;
    const Vec3 out = sides.count == 2 ? -edge : cross(edge, sides.normal);
    if (cut(faces[now], from, out, ClippedFace::kEdge + sides.corner_id[i], is_closed,
            faces[1 - now])) {
      now = 1 - now;
    }
  }
  ClippedFace clipped;
  clipped.count = faces[now].count;
  std::copy(faces[now].corner, faces[now].corner + clipped.count, clipped.corner);
  return clipped;
}

}  // namespace graze::narrowphase
