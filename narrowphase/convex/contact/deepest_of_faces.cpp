#include <graze/narrowphase/convex/contact/clip.h>
#include <graze/narrowphase/convex/contact/deepest_of_faces.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace graze::narrowphase {
namespace {

// Points are on a rim to this share of its radius.
constexpr double kOnRim = 0x1p-40;

// A face that leans from the normal by more says too little about where it is.
constexpr double kLeastFacing = 0.125;

/// A place in the plane of a disc, in units of its radius.
struct Flat {
  double x, y;
};

Flat operator+(const Flat& s, const Flat& t) {
  return {s.x + t.x, s.y + t.y};
}
Flat operator-(const Flat& s, const Flat& t) {
  return {s.x - t.x, s.y - t.y};
}
Flat operator*(const Flat& s, double by) {
  return {s.x * by, s.y * by};
}
double dot(const Flat& s, const Flat& t) {
  return s.x * t.x + s.y * t.y;
}
double cross(const Flat& s, const Flat& t) {
  return s.x * t.y - s.y * t.x;
}
Flat across(const Flat& s) {
  return {-s.y, s.x};
}

bool is_disc(const FaceOf& of) {
  return of.face.count > 2 &&
         (of.core.kind == CoreKind::Cylinder || of.core.kind == CoreKind::Cone);
}

bool has_sharp_corner(const FaceOf& of) {
  return of.core.kind != CoreKind::Box && is_sharp(of.face);
}

/// Holds a disc, and sees other faces in its plane along a direction.
class Disc {
 public:
  Disc(const FaceOf& of, const Vec3& along)
      : normal_(of.face.normal),
        along_(along * (1 / dot(of.face.normal, along))),
        radius_(of.core.half.x),
        axis_u_(of.core.axis[0]),
        axis_v_(of.core.axis[1]) {
    const bool is_upper = dot(normal_, of.core.axis[2]) > 0;
    const double out = is_upper ? of.core.half.z : -of.core.half.z;
    centre_ = of.core.at + of.core.axis[2] * out + normal_ * of.core.radius;
  }

  Flat seen(const Vec3& offset) const {
    const Vec3 within = offset - along_ * dot(normal_, offset);
    return Flat{dot(within, axis_u_), dot(within, axis_v_)} * (1 / radius_);
  }
  Flat place_of(const Vec3& point) const { return seen(point - centre_); }
  Vec3 point_at(const Flat& place) const { return centre_ + u() * place.x + v() * place.y; }

  const Vec3& centre() const { return centre_; }
  Vec3 u() const { return axis_u_ * radius_; }
  Vec3 v() const { return axis_v_ * radius_; }

 private:
  Vec3 normal_;
  Vec3 along_;  ///< a vector of such a length that it leads out of the plane by 1
  double radius_;
  Vec3 axis_u_, axis_v_;
  Vec3 centre_;
};

/// Keeps the best of the places that are offered, by how far they are along a direction.
class Farthest {
 public:
  explicit Farthest(const Flat& direction) : direction_(direction) {}
  void offer(const Flat& place) {
    const double far = dot(direction_, place);
    if (!best_ || far > far_) best_ = place, far_ = far;
  }
  const std::optional<Flat>& best() const { return best_; }

 private:
  Flat direction_;
  std::optional<Flat> best_;
  double far_ = 0;
};

bool is_in_polygon(std::span<const Flat> corners, const Flat& place) {
  double least = 0, most = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Flat& next = corners[i + 1 == corners.size() ? 0 : i + 1];
    const double side = cross(next - corners[i], place - corners[i]);
    least = std::min(least, side), most = std::max(most, side);
  }
  return (least < 0) != (most > 0);
}

/// Returns the place in both the unit disc and a polygon that is farthest along a unit direction.
std::optional<Flat> farthest_in_polygon(std::span<const Flat> corners, const Flat& direction) {
  if (is_in_polygon(corners, direction)) return direction;
  Farthest farthest(direction);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Flat& from = corners[i];
    const Flat offset = corners[i + 1 == corners.size() ? 0 : i + 1] - from;
    const double length = std::sqrt(dot(offset, offset));
    if (!(length > 0)) continue;
    // An edge is met by where its line is nearest to the middle: for corners that are a million
    // radii away the roots of a square equation would be off by all of the disc.
    const Flat along = offset * (1 / length), aside = across(along);
    const Flat nearest = aside * dot(from, aside);
    const double inner = 1 - dot(nearest, nearest);
    if (!(inner >= 0)) continue;
    const double root = std::sqrt(inner), start = dot(from, along);
    const double first = std::max(-root, start), last = std::min(root, start + length);
    if (!(first <= last)) continue;
    farthest.offer(nearest + along * first);
    farthest.offer(nearest + along * last);
  }
  return farthest.best();
}

/// Holds a disc as it is seen beside another: nearly a circle.
struct Ellipse {
  Flat centre, u, v;

  double area() const { return cross(u, v); }
  /// Returns an offset from its centre as it is in its own plane, in units of its radius.
  Flat own(const Flat& offset) const {
    return Flat{cross(offset, v), cross(u, offset)} * (1 / area());
  }
  bool has(const Flat& place) const {
    const Flat at = own(place - centre);
    return dot(at, at) <= 1 + kOnRim;
  }
  Flat farthest(const Flat& direction) const {
    const double by_u = dot(direction, u), by_v = dot(direction, v);
    const double length = std::sqrt(by_u * by_u + by_v * by_v);
    return centre + u * (by_u / length) + v * (by_v / length);
  }
};

/// Returns where the unit circle crosses the rim of an ellipse, near a place on it, by Newton's
/// method.
std::optional<Flat> on_both_rims(const Ellipse& other, Flat place) {
  constexpr int kMostSteps = 8;
  for (int i = 0; i < kMostSteps; ++i) {
    const Flat at = other.own(place - other.centre);
    const double beyond = dot(at, at) - 1;
    if (std::abs(beyond) <= kOnRim) return place;
    const Flat ahead = across(place);
    const double slope = 2 * dot(at, other.own(ahead));
    const Flat next = place - ahead * (beyond / slope);
    place = next * (1 / std::sqrt(dot(next, next)));
  }
  return std::nullopt;
}

/// Returns the place in both the unit disc and an ellipse that is farthest along a unit direction.
std::optional<Flat> farthest_in_ellipse(const Ellipse& other, const Flat& direction) {
  if (other.has(direction)) return direction;
  const Flat its = other.farthest(direction);
  if (dot(its, its) <= 1 + kOnRim) return its;
  const double square = dot(other.centre, other.centre);
  if (!(square > 0)) return std::nullopt;
  const double distance = std::sqrt(square);
  const double along =
      std::clamp((1 + square - std::abs(other.area())) / (2 * distance), -1.0, 1.0);
  const Flat to_it = other.centre * (1 / distance);
  const Flat aside = across(to_it) * std::sqrt(1 - along * along);
  Farthest farthest(direction);
  for (const Flat& start : {to_it * along + aside, to_it * along - aside}) {
    const std::optional<Flat> found = on_both_rims(other, start);
    if (found) farthest.offer(*found);
  }
  return farthest.best();
}

std::optional<Flat> farthest_in_face(const FaceOf& other, const Disc& disc, const Vec3& normal,
                                     const Flat& direction) {
  if (is_disc(other)) {
    const Disc its(other, normal);
    return farthest_in_ellipse(
        {disc.place_of(its.centre()), disc.seen(its.u()), disc.seen(its.v())}, direction);
  }
  Flat corners[ContactFace::kMostCorners];
  for (int i = 0; i < other.face.count; ++i)
    corners[i] = disc.place_of(other.face.corner[i]);
  return farthest_in_polygon({corners, static_cast<std::size_t>(other.face.count)}, direction);
}

/// Returns where a line along the normal through a point meets the plane of a face.
Vec3 on_plane(const ContactFace& face, const Vec3& point, const Vec3& normal) {
  return point + normal * (dot(face.normal, face.corner[0] - point) / dot(face.normal, normal));
}

/// Returns the deepest place on a round face, and the point of the other over it.
std::optional<MeetingPoints> deepest_of_disc(const FaceOf& round, const FaceOf& other,
                                             const Vec3& normal) {
  const Disc disc(round, normal);
  // This is how the depth grows across the disc, to a factor: away from where the other's face
  // leans.
  const Flat slope{-dot(other.face.normal, disc.u()), -dot(other.face.normal, disc.v())};
  const double steep = std::sqrt(dot(slope, slope));
  if (!(steep > 0)) return std::nullopt;
  const std::optional<Flat> place = farthest_in_face(other, disc, normal, slope * (1 / steep));
  if (!place) return std::nullopt;
  const Vec3 point = disc.point_at(*place);
  return MeetingPoints{point, on_plane(other.face, point, normal)};
}

/// Tells how far a point is beyond an edge of a polygon, as it is seen along a direction, to a
/// factor.
class PolygonEdges {
 public:
  PolygonEdges(const ContactFace& face, const Vec3& along) : face_(face) {
    const bool is_seen_from_outside = dot(face.normal, along) > 0;
    for (int i = 0; i < face.count; ++i) {
      const Vec3 edge = face.corner[i + 1 == face.count ? 0 : i + 1] - face.corner[i];
      out_[i] = is_seen_from_outside ? cross(edge, along) : cross(along, edge);
    }
  }
  int count() const { return face_.count; }
  double beyond(int side, const Vec3& point) const {
    return dot(point - face_.corner[side], out_[side]);
  }
  bool has(const Vec3& point) const {
    for (int i = 0; i < count(); ++i)
      if (beyond(i, point) > 0) return false;
    return true;
  }

 private:
  const ContactFace& face_;
  Vec3 out_[ContactFace::kMostCorners];
};

/// Returns the corner that is farthest along a direction.
const Vec3& farthest_corner(const ContactFace& face, const Vec3& direction) {
  int best = 0;
  double most = dot(face.corner[0], direction);
  for (int i = 1; i < face.count; ++i) {
    const double far = dot(face.corner[i], direction);
    if (far > most) best = i, most = far;
  }
  return face.corner[best];
}

/// Holds the part of an edge that lies between the sides of a polygon, as shares of the edge.
struct Within {
  double first = 0, last = 1;

  Within(const PolygonEdges& sides, const Vec3& from, const Vec3& to) {
    for (int i = 0; i < sides.count() && first <= last; ++i) {
      const double start = sides.beyond(i, from), end = sides.beyond(i, to);
      if (start > 0 && end > 0) first = 2;
      if (start > 0 && end <= 0) first = std::max(first, start / (start - end));
      if (start <= 0 && end > 0) last = std::min(last, start / (start - end));
    }
  }
};

/// Finds the deepest place. On B it is a corner of A, if that is over B, or on an edge of B.
std::optional<MeetingPoints> deepest_of_polygons(const ContactFace& a, const ContactFace& b,
                                                 const Vec3& normal) {
  const double facing_a = dot(a.normal, normal), facing_b = dot(b.normal, normal);
  // This is how the depth grows across the normal.
  const Vec3 slope = b.normal * (1 / facing_b) - a.normal * (1 / facing_a);
  const Vec3& of_a = farthest_corner(a, slope);
  if (PolygonEdges(b, normal).has(of_a)) return MeetingPoints{of_a, on_plane(b, of_a, normal)};
  const PolygonEdges sides(a, normal);
  std::optional<Vec3> best;
  double most = 0;
  for (int i = 0; i < b.count; ++i) {
    const Vec3 &from = b.corner[i], &to = b.corner[i + 1 == b.count ? 0 : i + 1];
    const Within within(sides, from, to);
    if (!(within.first <= within.last)) continue;
    const Vec3 offset = to - from;
    const double share = dot(offset, slope) > 0 ? within.last : within.first;
    const Vec3 place = from + offset * share;
    const double far = dot(place, slope);
    if (!best || far > most) best = place, most = far;
  }
  if (!best) return std::nullopt;
  return MeetingPoints{on_plane(a, *best, normal), *best};
}

/// Returns how much a plane leans from one across a normal: the sine between the two.
double lean_of(const Vec3& plane, const Vec3& normal) {
  return length(cross(plane, normal));
}

}  // namespace

std::optional<MeetingPoints> deepest_of_faces(const FaceOf& a, const FaceOf& b,
                                              const Vec3& normal) {
  const auto is_needle = [](const FaceOf& of) { return is_disc(of) && !(of.core.half.x > 0); };
  if (dot(a.face.normal, normal) < kLeastFacing || -dot(b.face.normal, normal) < kLeastFacing ||
      is_uneven(a) || is_uneven(b) || is_needle(a) || is_needle(b))
    return std::nullopt;
  if (is_disc(a)) return deepest_of_disc(a, b, normal);
  if (!is_disc(b)) {
    if (has_sharp_corner(a) || has_sharp_corner(b)) return std::nullopt;
    return deepest_of_polygons(a.face, b.face, normal);
  }
  const std::optional<MeetingPoints> found = deepest_of_disc(b, a, normal);
  if (!found) return std::nullopt;
  return MeetingPoints{found->on_b, found->on_a};
}

// Past an edge of A the depth falls by what the next face leans more than this one, and rises by no
// more than it does within both: by what the two lean from each other, and past a corner by more,
// the sharper it is.
bool are_deepest(const FaceOf& a, const FaceOf& b, const Vec3& normal) {
  constexpr double kTimes = 8;
  const double leans = lean_of(a.face.normal, normal) + lean_of(b.face.normal, normal);
  const auto is_edged = [&](const FaceOf& of) {
    if (of.core.radius > 0) return false;
    const double next = of.face.next_facing;
    return next <= 0 || 1 - next * next >= kTimes * kTimes * leans * leans * next * next;
  };
  return is_edged(a) && is_edged(b);
}

}  // namespace graze::narrowphase
