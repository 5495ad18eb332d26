#include <graze/engine/world/contacts/meshes/mesh_region_points.h>
#include <graze/engine/world/contacts/region_ends.h>
#include <graze/narrowphase/convex/core/segments.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace graze {
namespace {

using narrowphase::Vec3;

// A face that is parallel to the way out, to about 10 degrees, bounds no depth.
constexpr double kFacing = 0.17;

// Two faces lie along each other within 2 degrees, of which this is the cosine. Which of the two is
// left first then depends mostly on rounding, and points of either count in both cases.
constexpr double kAlong = 0.9994;

// A face lies in the region as a whole if it is at least this share as deep.
constexpr double kDeepFace = 0.5;

// More faces than this that go through others along their rim belong to a round surface.
constexpr int kMostRimFaces = 32;

// At most this many faces are looked at for the depths of points.
constexpr std::size_t kMostPlanes = 16;

// Lengths below this share of the region's size do not matter.
constexpr double kNegligible = 1e-9;

class RegionPoints {
  struct Plane {
    Vec3 normal;
    Vec3 point;
    double facing;  ///< the cosine of its angle to the way out
  };
  /// A point of a curve in which a face that lies along faces of the other mesh leaves them.
  struct Rim {
    Vec3 point;
    Vec3 normal;  ///< the normal of the face whose point it is
    bool is_of_a;
  };
  /// Memory that is kept from one region to the next, so that no step of a simulation allocates.
  struct Scratch {
    std::vector<Plane> planes;
    std::vector<MetPoints> met;
    std::vector<Rim> rims;
    std::vector<std::uint8_t> is_looked_at;
    std::vector<std::uint32_t> met_at;  ///< the place in `met` of each end of crossings
  };
  static constexpr std::uint32_t kNotMet = 0xffffffffu;
  static Scratch& scratch() {
    static thread_local Scratch scratch;
    return scratch;
  }

 public:
  RegionPoints(const MeshRegion& region, ContactCandidates& candidates)
      : region_(region),
        candidates_(candidates),
        exit_(region.left.parting.exit.direction),
        depth_(region.left.parting.exit.depth),
        size_(std::max(region.inner_a->radius, region.inner_b->radius)),
        planes_(scratch().planes),
        met_(scratch().met),
        rims_(scratch().rims) {}

  void run() {
    met_.clear(), rims_.clear();
    run_over_faces();
    add_rims();
    drop_doubles();
    double most = -1;
    for (const MetPoints& met : met_)
      most = std::max(most, met.depth);
    if (met_.empty() || depth_ - most > kSameMetDepth * size_) add_deepest();
    add_ends(met_,
             {.pose_a = region_.pose_a, .pose_b = region_.pose_b, .exit = exit_, .size = size_},
             candidates_.list);
  }

 private:
  void run_over_faces() {
    first_number_ = 0xffffffffu;
    std::uint32_t last = 0;
    for (const MeshCrossing& crossing : region_.crossings) {
      first_number_ = std::min({first_number_, crossing.from_number, crossing.to_number});
      last = std::max({last, crossing.from_number, crossing.to_number});
    }
    scratch().met_at.assign(last - first_number_ + 1, kNotMet);
    for (const bool is_of_a : {false, true})
      add_over_faces(is_of_a, last);
  }

  /// Adds points of one mesh over the faces of the other that count.
  void add_over_faces(bool faces_are_a, std::uint32_t last_number) {
    find_planes(faces_are_a);
    if (planes_.empty()) return;
    const InnerPart& inner = faces_are_a ? *region_.inner_b : *region_.inner_a;
    for (std::size_t i = 0; i < inner.points.size(); ++i) {
      if (inner.vertex[i] == InnerPart::kNoVertex || inner.is_outer[i]) continue;
      if (const std::optional<MetPoints> met = met_over(inner.points[i] + inner.at, faces_are_a))
        met_.push_back(*met);
    }
    // Most ends are shared by two crossings.
    std::vector<std::uint8_t>& is_looked_at = scratch().is_looked_at;
    is_looked_at.assign(last_number - first_number_ + 1, 0);
    for (const MeshCrossing& crossing : region_.crossings) {
      const Vec3& normal = faces_are_a ? crossing.normal_b : crossing.normal_a;
      const double facing = dot(normal, faces_are_a ? exit_ : -exit_);
      if (facing < kFacing) continue;
      for (const bool is_end : {false, true}) {
        const Vec3& point = is_end ? crossing.to : crossing.from;
        const std::uint32_t number =
            (is_end ? crossing.to_number : crossing.from_number) - first_number_;
        if (facing > kAlong && std::abs(depth_at(point)) < kNegligible * size_)
          rims_.push_back({point, normal, !faces_are_a});
        if (!std::exchange(is_looked_at[number], true)) add_end(point, number, faces_are_a);
      }
    }
  }

  /// Adds an end of a crossing. It is on both surfaces, and may lie over faces of both: it counts
  /// once, with its greater depth.
  void add_end(const Vec3& point, std::uint32_t number, bool faces_are_a) {
    const std::optional<MetPoints> met = met_over(point, faces_are_a);
    if (!met) return;
    std::uint32_t& at = scratch().met_at[number];
    if (at == kNotMet) {
      at = static_cast<std::uint32_t>(met_.size());
      met_.push_back(*met);
    } else if (met->depth > met_[at].depth) {
      met_[at] = *met;
    }
  }

  /// Adds points of the rim. Where a flat face leans, the region ends in a line along which it is 0
  /// deep: a corner that is lifted off gives its place to the point next to it, and not to just any
  /// edge of a triangle nearby. The rim of a round surface does not count: its facets there are far
  /// less deep than others.
  void add_rims() {
    if (region_.left.parting.feature != LeftFeature::Face || met_.empty()) return;
    const double deep_enough = kDeepFace * met_[deepest_of(met_, size_)].depth;
    const std::size_t count = met_.size();
    const auto is_deep = [&](const Rim& rim) {
      return std::any_of(met_.begin(), met_.begin() + static_cast<std::ptrdiff_t>(count),
                         [&](const MetPoints& met) {
                           const Vec3& own = rim.is_of_a ? met.a : met.b;
                           return met.depth >= deep_enough && is_on_plane(own, rim);
                         });
    };
    bool counts = false;
    const Rim* last = nullptr;
    int faces = 0;
    for (const Rim& rim : rims_) {
      const bool is_known = last != nullptr && last->is_of_a == rim.is_of_a &&
                            is_one_direction(last->normal, rim.normal) &&
                            is_on_plane(rim.point, *last);
      if (!is_known) {
        if (++faces > kMostRimFaces) return;
        counts = is_deep(rim);
      }
      last = &rim;
      if (counts) met_.push_back({rim.point, rim.point, 0});
    }
  }
  bool is_on_plane(const Vec3& point, const Rim& rim) const {
    return std::abs(dot(point - rim.point, rim.normal)) <= kNegligible * size_;
  }

  /// Finds the faces of one mesh behind which points of the other have depths: those that lie along
  /// the face that is left, or if an edge is left those nearly at right angles to the way out.
  void find_planes(bool faces_are_a) {
    planes_.clear();
    planes_are_a_ = faces_are_a;
    const bool is_face = region_.left.parting.feature == LeftFeature::Face;
    if (is_face && faces_are_a == region_.is_of_a) {
      planes_.push_back({faces_are_a ? -exit_ : exit_, region_.left.triangle.corner[0], 1});
    } else {
      for (const MeshCrossing& crossing : region_.crossings) {
        const Vec3& normal = faces_are_a ? crossing.normal_a : crossing.normal_b;
        const double facing = (faces_are_a ? -1 : 1) * dot(normal, exit_);
        if (facing < (is_face ? kAlong : kNearlyFacing) || planes_.size() == kMostPlanes) continue;
        planes_.push_back({normal, (crossing.from + crossing.to) * 0.5, facing});
      }
    }
    is_one_plane_ = true;
    for (const Plane& plane : planes_) {
      is_one_plane_ &=
          length(cross(plane.normal, planes_[0].normal)) <= kNegligible &&
          std::abs(dot(plane.point - planes_[0].point, planes_[0].normal)) <= kNegligible * size_;
    }
  }

  /// Returns how deep a point is behind the face that is nearest to it as seen along the way out.
  double depth_at(const Vec3& point) const {
    double least = std::numeric_limits<double>::infinity(), depth = 0;
    for (const Plane& plane : planes_) {
      const double behind = dot(plane.point - point, plane.normal) / plane.facing;
      if (is_one_plane_) return behind;
      const Vec3 beside = point + exit_ * (planes_are_a_ ? -behind : behind) - plane.point;
      const double square = dot(beside, beside);
      if (square < least) least = square, depth = behind;
    }
    return depth;
  }

  std::optional<MetPoints> met_over(const Vec3& point, bool faces_are_a) const {
    const double sign = faces_are_a ? -1 : 1;
    const double depth = depth_at(point);
    // Points where the surfaces go through each other add nothing to deeper points.
    if (depth < kNegligible * size_ || depth > depth_ + kSameMetDepth * size_) return std::nullopt;
    const Vec3 met = point + exit_ * (sign * depth);
    return faces_are_a ? MetPoints{met, point, depth} : MetPoints{point, met, depth};
  }

  /// Adds the point at which the body that leaves is deepest beyond the feature that it leaves
  /// last.
  void add_deepest() {
    const InnerPart& inner = region_.is_of_a ? *region_.inner_b : *region_.inner_a;
    const Vec3 out = region_.is_of_a ? exit_ : -exit_;
    const Segment deepest = farthest_of(inner, out);
    // These are the places of the deepest points, relative to the feature, once the two have
    // parted.
    const Vec3 from = deepest.from - out * depth_, to = deepest.to - out * depth_;
    const LocalParting& left = region_.left.parting;
    const Vec3* corner = region_.left.triangle.corner;
    Vec3 met = from;
    if (left.feature == LeftFeature::Edge && !region_.is_scattered) {
      met = nearest_of_segments(from, to, corner[left.which], corner[(left.which + 1) % 3]).point_a;
    }
    const Vec3 sunk = met + out * depth_;
    met_.push_back({region_.is_of_a ? met : sunk, region_.is_of_a ? sunk : met, depth_});
  }

  /// The farthest points of a part: one point, or the ends of an edge.
  struct Segment {
    Vec3 from;
    Vec3 to;
  };
  Segment farthest_of(const InnerPart& inner, const Vec3& out) const {
    double most = -std::numeric_limits<double>::infinity();
    for (const Vec3& point : inner.points)
      most = std::max(most, dot(point, out));
    const double least = most - kNegligible * size_;
    // If the depth is no more than rounding, all points of a flush face are as deep, even beyond
    // the other mesh: only points of the curves are on both surfaces.
    const auto is_on_curve = [&](std::size_t i) {
      return inner.vertex[i] == InnerPart::kNoVertex && dot(inner.points[i], out) >= least;
    };
    bool is_of_curves = false;
    for (std::size_t i = 0; depth_ <= kNegligible * size_ && i < inner.points.size(); ++i)
      is_of_curves |= is_on_curve(i);
    std::size_t first = inner.points.size(), last = 0;
    double farthest = -1;
    for (std::size_t i = 0; i < inner.points.size(); ++i) {
      if (dot(inner.points[i], out) < least || (is_of_curves && !is_on_curve(i))) continue;
      if (first == inner.points.size()) first = i;
      const double away = length(inner.points[i] - inner.points[first]);
      if (away > farthest) farthest = away, last = i;
    }
    return {inner.points[first] + inner.at, inner.points[last] + inner.at};
  }

  /// Removes doubles: points that two crossings share, or that are on both surfaces, are found
  /// twice.
  void drop_doubles() {
    // Sorted by a coordinate, doubles are near each other.
    std::sort(met_.begin(), met_.end(), [](const MetPoints& s, const MetPoints& t) {
      if (s.a.x != t.a.x) return s.a.x < t.a.x;
      if (s.a.y != t.a.y) return s.a.y < t.a.y;
      return s.a.z != t.a.z ? s.a.z < t.a.z : s.depth > t.depth;
    });
    const double within = kNegligible * size_;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < met_.size(); ++i) {
      bool is_double = false;
      for (std::size_t j = kept; j-- > 0 && !is_double;) {
        if (met_[i].a.x - met_[j].a.x > within) break;
        is_double = largest(met_[i].a - met_[j].a) <= within;
      }
      if (!is_double) met_[kept++] = met_[i];
    }
    met_.resize(kept);
  }

  const MeshRegion& region_;
  ContactCandidates& candidates_;
  Vec3 exit_;  ///< the direction in which A leaves
  double depth_;
  double size_;
  std::uint32_t first_number_ = 0;  ///< the first number of the ends of crossings
  bool is_one_plane_ = true;
  bool planes_are_a_ = false;
  std::vector<Plane>& planes_;
  std::vector<MetPoints>& met_;
  std::vector<Rim>& rims_;
};

}  // namespace

void add_region_points(const MeshRegion& region, ContactCandidates& candidates) {
  RegionPoints(region, candidates).run();
}

}  // namespace graze
