// With w = v - o for a corner v of a face, and its normal n, the line o + s d is in the face's
// plane at s = (n . w) / (n . d). It passes an edge from p to q on the face's side, seen from
// outside, if
// ((p - o) x (q - o)) . d <= 0; where the line comes from outside not all edges of the face are
// passed with 0, as the signs add up to that of n . d < 0.
//
// Of a line that meets the hull some face is entered so: at the point where it enters the planes of
// faces cut away all that lies before it, and so not all of them hold the line.

#include <graze/narrowphase/convex/core/exact_line.h>
#include <graze/narrowphase/convex/core/hull_ray.h>

#include <algorithm>

namespace graze::narrowphase {
namespace {

// With B the bounding radius and the largest coordinate of the origin: no coordinate of w is more.
// A normal is off by 8 u each component, which moves a plane by 24 u B; corners were rounded
// once, 1.8 u B; two dot products of three terms and their difference are off by 12.2 u B. A slope
// is off by 24 u and 6 u more, and no s within the hull is beyond 2 B: 60 u B. Quotients add 2 u of
// sqrt(3) B.
constexpr double kRoundings = 0x80p-53;
constexpr double kSlopeRoundings = 0x20p-53;

// Differences p - o are off by 2 u B, and so a component of the product of two by 8 u B^2, and 4 u
// B^2 for its own roundings. A dot product with d takes three of them, 36 u B^2 |d|, and rounds
// products of at most 2 B^2 |d| once and sums of them twice: 16 u.
constexpr double kEdgeRoundings = 0x40p-53;

// Where the direction comes down on the face more steeply, the rounded distance serves: what moves
// the plane by kRoundings moves the point by eight times as much at most.
constexpr double kSteep = 0.125;

class RayAtHull {
 public:
  RayAtHull(const Hull& hull, const Vec3& origin, const Vec3& direction, HullRayStart start)
      : hull_(hull), origin_(origin), direction_(direction), start_(start) {
    const double size = hull.bounding_radius + largest(origin);
    room_error_ = kRoundings * size;
    edge_error_ = kEdgeRoundings * (size * size) * largest(direction);
    enter_ = start == HullRayStart::Here ? 0 : -2 * size;
    exit_ = 2 * size;
  }

  std::optional<HullRayHit> run() {
    if (!cut_by_planes()) return std::nullopt;
    if (start_ == HullRayStart::Here && !is_surely_outside_ && begins_inside())
      return HullRayHit{0, {}};
    if (const Hull::Face* face = walk_from(last_)) return hit(*face);
    for (const Hull::Face& face : hull_.faces) {
      if (!may_be_entered(face) || !passes(face)) continue;
      // The line enters the hull here, so that a ray that begins outside and behind this plane is
      // past it.
      if (start_ == HullRayStart::Here && side_of_origin(face) != Sign::Negative)
        return std::nullopt;
      return hit(face);
    }
    return std::nullopt;
  }

 private:
  double room(const Hull::Face& face) const {
    return hull_.offsets[static_cast<std::size_t>(&face - hull_.faces.data())] -
           dot(face.normal, origin_);
  }

  /// Keeps of [enter_, exit_] what may be in the hull; false if that is surely nothing.
  bool cut_by_planes() {
    for (const Hull::Face& face : hull_.faces) {
      const double to_plane = room(face);
      is_surely_outside_ |= to_plane < -room_error_;
      const double most = to_plane + room_error_;
      const double slope = dot(face.normal, direction_);
      if (slope < 0) {
        const double s = most / slope;
        if (s > enter_) enter_ = s, last_ = &face;
      } else if (slope > 0) {
        exit_ = std::min(exit_, most / slope);
      } else if (most < 0) {
        return false;
      }
    }
    return enter_ <= exit_;
  }

  /// True if the ray begins inside, for an origin that no rounded plane shows to be outside.
  bool begins_inside() const {
    return std::all_of(hull_.faces.begin(), hull_.faces.end(), [&](const Hull::Face& face) {
      return side_of_origin(face) != Sign::Negative;
    });
  }

  /// Returns Positive if the origin is behind the face's plane.
  Sign side_of_origin(const Hull::Face& face) const {
    const double rounded = room(face);
    if (std::abs(rounded) > room_error_) return rounded > 0 ? Sign::Positive : Sign::Negative;
    return exact_.side_of_origin(face);
  }

  /// True if the line may come from outside into the face within [enter_, exit_]. Twice the error
  /// is allowed, as both ends have been rounded, too.
  bool may_be_entered(const Hull::Face& face) const {
    const double slope = dot(face.normal, direction_);
    if (slope > kSlopeRoundings) return false;
    const double to_plane = room(face);
    return std::min(to_plane - enter_ * slope, to_plane - exit_ * slope) <= 2 * room_error_;
  }

  /// Returns the face through whose inside the line surely comes from outside: it goes from face to
  /// face over edges that the line passes beyond. Returns null where a rounded sign is not sure, or
  /// after many steps: where faces are nearly in line the first is a bad guess, and rounding may
  /// lead in a circle.
  const Hull::Face* walk_from(const Hull::Face* face) const {
    constexpr int kMostSteps = 64;
    for (int step = 0; step < kMostSteps && face != nullptr; ++step) {
      const Hull::Face* next = next_towards_line(*face);
      if (next == face) return face;
      face = next;
    }
    return nullptr;
  }

  const Hull::Face* next_towards_line(const Hull::Face& face) const {
    bool is_sure = true;
    for (std::uint32_t i = 0; i < face.count; ++i) {
      const auto [from, to] = edge(face, i);
      const double volume = volume_beside(from, to);
      if (volume > edge_error_) return &hull_.faces[hull_.beyond[face.first + i]];
      is_sure &= volume < -edge_error_;
    }
    return is_sure ? &face : nullptr;
  }

  /// True if the line goes from outside through the closed face.
  bool passes(const Hull::Face& face) const {
    bool is_through = false;
    for (std::uint32_t i = 0; i < face.count; ++i) {
      const auto [from, to] = edge(face, i);
      const Sign side = side_of_edge(from, to);
      if (side == Sign::Positive) return false;
      is_through |= side == Sign::Negative;
    }
    return is_through;
  }

  struct Edge {
    std::uint32_t from, to;
  };
  Edge edge(const Hull::Face& face, std::uint32_t i) const {
    const std::uint32_t next = i + 1 == face.count ? 0 : i + 1;
    return {hull_.loops[face.first + i], hull_.loops[face.first + next]};
  }

  double volume_beside(std::uint32_t from, std::uint32_t to) const {
    const Vec3 p = hull_.corners[from] - origin_, q = hull_.corners[to] - origin_;
    return dot(cross(p, q), direction_);
  }

  Sign side_of_edge(std::uint32_t from, std::uint32_t to) const {
    const double volume = volume_beside(from, to);
    if (std::abs(volume) > edge_error_) return volume > 0 ? Sign::Positive : Sign::Negative;
    return exact_.side_of_edge(from, to);
  }

  HullRayHit hit(const Hull::Face& face) const {
    const double slope = dot(face.normal, direction_);
    const bool is_steep = slope < -kSteep * largest(direction_);
    return {is_steep ? room(face) / slope : exact_.distance(face), face.normal};
  }

  const Hull& hull_;
  const Vec3& origin_;
  const Vec3& direction_;
  HullRayStart start_;
  ExactLine exact_{hull_, origin_, direction_};
  double room_error_, edge_error_;
  double enter_, exit_;               ///< no s outside of these is in the hull
  const Hull::Face* last_ = nullptr;  ///< the face whose plane set `enter_`
  bool is_surely_outside_ = false;    ///< true if the origin surely is outside
};

}  // namespace

std::optional<HullRayHit> cast_ray(const Hull& hull, const Vec3& origin, const Vec3& direction,
                                   HullRayStart start) {
  return RayAtHull(hull, origin, direction, start).run();
}

}  // namespace graze::narrowphase
