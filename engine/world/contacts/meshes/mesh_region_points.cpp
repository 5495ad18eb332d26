#include <graze/engine/world/contacts/meshes/mesh_region_points.h>
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

// Two faces lie along each other within 2 degrees. Which of the two is left sooner is then nearly
// rounding, and points of either count in both cases.
constexpr double kAlong = 0.9994;

// A face that is this share as deep as the region lies in it as a whole.
constexpr double kDeepFace = 0.5;

// More faces than these go through others along their rim: they are those of a round surface.
constexpr int kMostRimFaces = 32;

// So many faces are looked at for the depths of points.
constexpr std::size_t kMostPlanes = 16;

// Lengths below this share of the region's size do not matter.
constexpr double kNegligible = 1e-9;

// A depth that lacks less than this share of the region's size is the greatest.
constexpr double kSameDepth = 1e-9;

// Ends are as deep as the deepest point if they lack less than these shares of its depth and of the
// region's size. With a thousandth tall stacks of drums sway on: whatever corner is no contact is
// let down until it is one.
constexpr double kLevelDepth = 3e-3, kLevelSize = 1e-5;

/// The axis of a frame that a direction is nearest to, 0 to 5.
std::uint64_t side_of(const Pose& pose, const Vec3& direction) {
  const double* m = pose.data();  // column-major 4x4
  std::uint64_t best = 0;
  double most = -1;
  for (std::uint64_t k = 0; k < 3; ++k) {
    const double along = dot({m[4 * k], m[4 * k + 1], m[4 * k + 2]}, direction);
    if (std::abs(along) > most) most = std::abs(along), best = 2 * k + (along < 0);
  }
  return best;
}

class RegionPoints {
  struct Plane {
    Vec3 normal;
    Vec3 point;
    double facing;  ///< cosine of its angle to the way out
  };
  /// Where the two meet: points of either mesh, and how deep they are.
  struct Met {
    Vec3 a;
    Vec3 b;
    double depth;
  };
  /// A point of a curve in which a face that lies along those of the other mesh leaves them.
  struct Rim {
    Vec3 point;
    Vec3 normal;  ///< of the face whose point it is
    bool is_of_a;
  };
  /// Kept from one region to the next, so that no step of a simulation allocates.
  struct Scratch {
    std::vector<Plane> planes;
    std::vector<Met> met;
    std::vector<Rim> rims;
    std::vector<std::uint8_t> is_looked_at;
    std::vector<std::uint32_t> met_at;  ///< of each end of crossings, its place in `met`
  };
  static constexpr std::uint32_t kNotMet = 0xffffffffu;
  using Ends = std::array<std::size_t, 4>;  ///< the last points in four directions
  static Scratch& scratch() {
    static thread_local Scratch scratch;
    return scratch;
  }

 public:
  RegionPoints(const MeshRegion& region, ContactCandidates& candidates)
      : region_(region),
        candidates_(candidates),
        way_(region.left.parting.exit.direction),
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
    for (const Met& met : met_)
      most = std::max(most, met.depth);
    if (met_.empty() || depth_ - most > kSameDepth * size_) add_deepest();
    keep_ends();
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

  /// Points of the one mesh over the faces of the other that count.
  void add_over_faces(bool faces_are_a, std::uint32_t last_number) {
    find_planes(faces_are_a);
    if (planes_.empty()) return;
    const InnerPart& inner = faces_are_a ? *region_.inner_b : *region_.inner_a;
    for (std::size_t i = 0; i < inner.points.size(); ++i) {
      if (inner.vertex[i] == InnerPart::kNoVertex || inner.is_outer[i]) continue;
      if (const std::optional<Met> met = met_over(inner.points[i] + inner.at, faces_are_a))
        met_.push_back(*met);
    }
    // Most ends are those of two crossings.
    std::vector<std::uint8_t>& is_looked_at = scratch().is_looked_at;
    is_looked_at.assign(last_number - first_number_ + 1, 0);
    for (const MeshCrossing& crossing : region_.crossings) {
      const Vec3& normal = faces_are_a ? crossing.normal_b : crossing.normal_a;
      const double facing = dot(normal, faces_are_a ? way_ : -way_);
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

  /// An end of a crossing is on both surfaces, and may lie over faces of both: it counts once, as
  /// deep as it is over either.
  void add_end(const Vec3& point, std::uint32_t number, bool faces_are_a) {
    const std::optional<Met> met = met_over(point, faces_are_a);
    if (!met) return;
    std::uint32_t& at = scratch().met_at[number];
    if (at == kNotMet) {
      at = static_cast<std::uint32_t>(met_.size());
      met_.push_back(*met);
    } else if (met->depth > met_[at].depth) {
      met_[at] = *met;
    }
  }

  /// Where a flat face leans, what it has in common with the other ends in a line along which it is
  /// 0 deep: a corner that is lifted off gives its place to the point next to it, and not to
  /// whatever edge of a triangle is near. Of a round surface the rim says nothing: its facets there
  /// are far less deep than others.
  void add_rims() {
    if (region_.left.parting.feature != LeftFeature::Face || met_.empty()) return;
    const double deep_enough = kDeepFace * met_[deepest()].depth;
    const std::size_t count = met_.size();
    const auto is_deep = [&](const Rim& rim) {
      return std::any_of(met_.begin(), met_.begin() + static_cast<std::ptrdiff_t>(count),
                         [&](const Met& met) {
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

  /// The faces of one mesh that points of the other are deep in: those that lie along the face that
  /// is left, or where an edge is left those nearly at right angles to the way out.
  void find_planes(bool faces_are_a) {
    planes_.clear();
    planes_are_a_ = faces_are_a;
    const bool is_face = region_.left.parting.feature == LeftFeature::Face;
    if (is_face && faces_are_a == region_.is_of_a) {
      planes_.push_back({faces_are_a ? -way_ : way_, region_.left.triangle.corner[0], 1});
    } else {
      for (const MeshCrossing& crossing : region_.crossings) {
        const Vec3& normal = faces_are_a ? crossing.normal_a : crossing.normal_b;
        const double facing = (faces_are_a ? -1 : 1) * dot(normal, way_);
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

  /// How deep a point is behind the face that is nearest to it as seen along the way out.
  double depth_at(const Vec3& point) const {
    double least = std::numeric_limits<double>::infinity(), depth = 0;
    for (const Plane& plane : planes_) {
      const double behind = dot(plane.point - point, plane.normal) / plane.facing;
      if (is_one_plane_) return behind;
      const Vec3 beside = point + way_ * (planes_are_a_ ? -behind : behind) - plane.point;
      const double square = dot(beside, beside);
      if (square < least) least = square, depth = behind;
    }
    return depth;
  }

  std::optional<Met> met_over(const Vec3& point, bool faces_are_a) const {
    const double sign = faces_are_a ? -1 : 1;
    const double depth = depth_at(point);
    // Where the surfaces go through each other they say nothing that deeper points do not.
    if (depth < kNegligible * size_ || depth > depth_ + kSameDepth * size_) return std::nullopt;
    const Vec3 met = point + way_ * (sign * depth);
    return faces_are_a ? Met{met, point, depth} : Met{point, met, depth};
  }

  /// Where the body that leaves is deepest beyond the feature that it leaves last.
  void add_deepest() {
    const InnerPart& inner = region_.is_of_a ? *region_.inner_b : *region_.inner_a;
    const Vec3 out = region_.is_of_a ? way_ : -way_;
    const Segment deepest = deepest_of(inner, out);
    // Seen from the feature, where it is once the two have parted.
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

  /// The farthest points of a part: one, or the ends of an edge.
  struct Segment {
    Vec3 from;
    Vec3 to;
  };
  Segment deepest_of(const InnerPart& inner, const Vec3& out) const {
    double most = -std::numeric_limits<double>::infinity();
    for (const Vec3& point : inner.points)
      most = std::max(most, dot(point, out));
    const double least = most - kNegligible * size_;
    // What is no deeper than rounding is all of a flush face, beyond the other mesh as well: points
    // of the curves alone are on both surfaces.
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

  /// Leaves the ends in directions that turn with A, and the deepest. A contact is known by the
  /// sides of A and of B that the way out leads to and by which end it is, so that it keeps its
  /// name while triangles change.
  void keep_ends() {
    const std::uint64_t side_a = side_of(region_.pose_a, -way_);
    const std::uint64_t side_b = side_of(region_.pose_b, -way_);
    Ends ends = ends_about(side_a / 2);
    take_deepest(ends);
    for (auto own = ends.begin(); own != ends.end(); ++own) {
      if (std::find(ends.begin(), own, *own) != own) continue;
      candidates_.list.push_back(
          {.point_a = met_[*own].a,
           .point_b = met_[*own].b,
           .normal = -way_,
           .depth = met_[*own].depth,
           .feature_a = side_a << 3 | static_cast<std::uint64_t>(own - ends.begin()),
           .feature_b = side_b});
    }
  }

  /// In directions across the way out, which an axis of A is nearest to; askew to A's axes, as
  /// edges seldom are.
  Ends ends_about(std::size_t k) const {
    const double* m = region_.pose_a.data();  // column-major 4x4
    const auto axis = [&](std::size_t i) {
      return Vec3{m[4 * (i % 3)], m[4 * (i % 3) + 1], m[4 * (i % 3) + 2]};
    };
    constexpr double kCosine = 0.95, kSine = 0.31;
    // How deep a point is does not tell how far out it is.
    const auto across = [&](const Vec3& along) { return along - way_ * dot(along, way_); };
    const Vec3 u = across(axis(k + 1) * kCosine + axis(k + 2) * kSine);
    const Vec3 v = across(axis(k + 2) * kCosine - axis(k + 1) * kSine);
    return {last_along(u), last_along(v), last_along(u * -1), last_along(v * -1)};
  }

  /// Of what is level any point may be the deepest by rounding: an end stands for it. Else the
  /// deepest takes a place and its name, so that a solver finds the impulse of the last step: one
  /// that another has as well, or that of the deepest end, with which it is level where the two
  /// change places.
  void take_deepest(Ends& ends) const {
    auto place = std::max_element(ends.begin(), ends.end(), [&](std::size_t s, std::size_t t) {
      return met_[s].depth < met_[t].depth;
    });
    const std::size_t deepest = this->deepest();
    const double most = met_[deepest].depth;
    if (most - met_[*place].depth <= std::min(kLevelDepth * most, kLevelSize * size_)) return;
    for (auto own = ends.end(); own-- != ends.begin();)
      if (std::find(ends.begin(), own, *own) != own) place = own;
    *place = deepest;
  }

  std::size_t deepest() const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < met_.size(); ++i)
      if (met_[i].depth > met_[best].depth + kSameDepth * size_) best = i;
    return best;
  }

  std::size_t last_along(const Vec3& direction) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < met_.size(); ++i)
      if (dot(met_[i].a - met_[best].a, direction) > kNegligible * size_) best = i;
    return best;
  }

  /// Points that two crossings share, or that are on both surfaces, are found twice.
  void drop_doubles() {
    // Sorted by a coordinate, doubles are near each other.
    std::sort(met_.begin(), met_.end(), [](const Met& s, const Met& t) {
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
  Vec3 way_;  ///< in which A leaves
  double depth_;
  double size_;
  std::uint32_t first_number_ = 0;  ///< of the ends of crossings
  bool is_one_plane_ = true;
  bool planes_are_a_ = false;
  std::vector<Plane>& planes_;
  std::vector<Met>& met_;
  std::vector<Rim>& rims_;
};

}  // namespace

void add_region_points(const MeshRegion& region, ContactCandidates& candidates) {
  RegionPoints(region, candidates).run();
}

}  // namespace graze
