#include <graze/narrowphase/convex/clip.h>

namespace graze::narrowphase {
namespace {

/// Keeps what is not in front of the plane through `on` with the outward normal `out`.
void cut(ClippedFace& face, const Vec3& on, const Vec3& out, std::uint32_t edge, bool is_closed) {
  ClippedFace kept;
  const int n = face.count;
  const auto keep = [&](const ClippedFace::Corner& corner) {
    if (kept.count < ClippedFace::kMostCorners) kept.corner[kept.count++] = corner;
  };
  for (int i = 0; i < n; ++i) {
    const ClippedFace::Corner& from = face.corner[i];
    const ClippedFace::Corner& to = face.corner[(i + 1) % n];
    const double height_from = dot(from.point - on, out);
    const double height_to = dot(to.point - on, out);
    if (height_from <= 0) keep(from);
    if (i + 1 == n && !is_closed) break;  // a segment has no way back
    if ((height_from < 0 && height_to > 0) || (height_from > 0 && height_to < 0)) {
      const double share = height_from / (height_from - height_to);
      const std::uint32_t own = ClippedFace::kEdge + (from.own & (ClippedFace::kEdge - 1));
      keep({from.point + (to.point - from.point) * share, own, edge});
    }
  }
  face = kept;
}

}  // namespace

ClippedFace clip(const ContactFace& face, const ContactFace& sides) {
  ClippedFace clipped;
  for (int i = 0; i < face.count; ++i)
    clipped.corner[clipped.count++] = {face.corner[i], face.corner_id[i], 0};
  const bool is_closed = face.count > 2;
  for (int i = 0; i < sides.count && sides.count > 1; ++i) {
    const Vec3& from = sides.corner[i];
    const Vec3 edge = sides.corner[(i + 1) % sides.count] - from;
    const Vec3 out = sides.count == 2 ? -edge : cross(edge, sides.normal);
    cut(clipped, from, out, ClippedFace::kEdge + sides.corner_id[i], is_closed);
  }
  return clipped;
}

}  // namespace graze::narrowphase
