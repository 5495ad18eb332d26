#include <graze/engine/compare/judge/bodies/body_judges.h>
#include <graze/engine/compare/judge/rational/in_metres.h>
#include <graze/engine/compare/judge/rational/rational_ray.h>
#include <graze/engine/mesh/placement.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace graze::compare {
namespace {

using Eigen::Vector3d;

/// A component of a normal is off by at most 8 units of 2^-53, and so the whole by 14 of them.
constexpr double kNormalTolerance = 0x1p-48;

struct Meeting {
  std::uint32_t triangle;
  mpq_class s;
  mpq_class square;  ///< the square of the distance
  double distance;   ///< the distance, rounded
};

double ulp_at(double value) {
  const double next = std::nextafter(value, std::numeric_limits<double>::infinity());
  return std::isfinite(next) ? next - value : 0x1p+971;
}

class SurfaceRay {
 public:
  SurfaceRay(const Case& query, bool is_graze)
      : ray_(std::get<Ray>(*query.b)), exact_(exactly(ray_)), ulps_(is_graze ? 4 : kTouchUlps) {
    if (const auto* t = std::get_if<Triangle>(&query.a)) {
      triangles_ = {*t};
      has_numbers_ = false;
    } else {
      const auto& mesh = std::get<CaseMesh>(query.a);
      for (std::size_t i = 0; i < mesh.mesh.triangles().size(); ++i)
        triangles_.push_back(place(mesh.pose, mesh.mesh.triangle(i)));
    }
    const mpq_class length = dot(exact_.direction, exact_.direction);
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      const std::optional<mpq_class> s = first_meeting(exact_, compare::exactly(triangles_[i]));
      if (!s) continue;
      const mpq_class square = *s * *s * length;
      const double distance = rounded_root(square);
      if (distance <= ray_.max_distance + bound(distance))
        meetings_.push_back({i, *s, square, distance});
    }
    std::sort(meetings_.begin(), meetings_.end(), [](const Meeting& a, const Meeting& b) {
      return a.square != b.square ? a.square < b.square : a.triangle < b.triangle;
    });
  }

  std::string truth() const {
    if (meetings_.empty()) return "no hit";
    return in_metres("hit after", meetings_.front().distance);
  }

  const std::vector<Meeting>& meetings() const { return meetings_; }

  bool is_within_range(const Meeting& meeting) const {
    return meeting.distance <= ray_.max_distance - bound(meeting.distance);
  }

  double bound(double distance) const {
    return std::isfinite(distance) ? ulps_ * ulp_at(distance) : 0;
  }

  /// Returns what is wrong with a hit, and by how much; nothing if it is right.
  std::optional<std::pair<std::string, double>> fault_of(const RayHit& hit) const {
    const auto found =
        std::find_if(meetings_.begin(), meetings_.end(), [&](const Meeting& meeting) {
          return has_numbers_ ? meeting.triangle == hit.triangle : hit.triangle == kNoTriangle;
        });
    if (found == meetings_.end()) return std::pair("a triangle that the ray misses", 0.0);
    const double off = root_error(hit.distance, found->square);
    if (off > bound(found->distance)) return std::pair("another distance", off);
    const RationalPoint at = exact_.at(found->s);
    const RationalPoint offset = minus(compare::exactly(hit.point), at);
    const double off_point = rounded_root(dot(offset, offset));
    const double largest = std::max(found->distance, ray_.origin.cwiseAbs().maxCoeff());
    // This is for each of three coordinates.
    if (off_point > 2 * ulps_ * ulp_at(largest)) return std::pair("another point", off_point);
    const double off_normal = (hit.normal - normal_at(found->triangle)).norm();
    if (!(off_normal <= kNormalTolerance)) return std::pair("another normal", off_normal);
    return std::nullopt;
  }

 private:
  /// Returns the normal on the side that the ray comes from; the ray's own where there is no other.
  Vector3d normal_at(std::uint32_t triangle) const {
    const RationalTriangle t = compare::exactly(triangles_[triangle]);
    RationalPoint normal = cross(edge_of(t, 0), edge_of(t, 1));
    const mpq_class approach = dot(normal, exact_.direction);
    if (approach == 0) normal = exact_.direction;
    const int sign = approach == 0 ? -1 : -sgn(approach);
    const mpq_class square = dot(normal, normal);
    Vector3d rounded;
    for (int axis = 0; axis < 3; ++axis) {
      const mpq_class share = normal[axis] * normal[axis] / square;
      rounded[axis] = sign * sgn(normal[axis]) * rounded_root(share);
    }
    return rounded;
  }

  const Ray& ray_;
  RationalRay exact_;
  double ulps_;
  bool has_numbers_ = true;
  std::vector<Triangle> triangles_;
  std::vector<Meeting> meetings_;
};

Judgement wrong(const std::string& truth, const std::string& what, double error) {
  Judgement judgement;
  judgement.verdict = Verdict::Wrong;
  judgement.truth = truth + ", but " + what;
  judgement.error = error;
  return judgement;
}

}  // namespace

Judgement judge_surface_ray(const Case& query, const CaseAnswer& answer, bool is_graze) {
  const SurfaceRay ray(query, is_graze);
  const std::vector<RayHit>& hits = *answer.hits;
  const auto must_be_told = [&](const Meeting& m) { return ray.is_within_range(m); };
  const auto told = static_cast<std::ptrdiff_t>(hits.size());
  const std::ptrdiff_t due =
      std::count_if(ray.meetings().begin(), ray.meetings().end(), must_be_told);
  const bool is_all = query.ask == Ask::RayAll;
  if (told < (is_all ? due : std::min<std::ptrdiff_t>(due, 1)))
    return wrong(ray.truth(), "overlooked", 0);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (const auto fault = ray.fault_of(hits[i]))
      return wrong(ray.truth(), fault->first, fault->second);
    if (i == 0) continue;
    const bool do_ascend =
        hits[i - 1].distance < hits[i].distance ||
        (hits[i - 1].distance == hits[i].distance && hits[i - 1].triangle < hits[i].triangle);
    if (!do_ascend) return wrong(ray.truth(), "a list that does not ascend", 0);
  }
  if (!is_all && hits.size() > 1) return wrong(ray.truth(), "more than the first", 0);
  if (!is_all && !hits.empty()) {
    const double first = ray.meetings().front().distance;
    if (hits[0].distance > first + 2 * ray.bound(first))
      return wrong(ray.truth(), "not the first", hits[0].distance - first);
  }
  Judgement judgement;
  judgement.verdict = Verdict::Right;
  judgement.truth =
      is_all ? std::to_string(hits.size()) + (hits.size() == 1 ? " hit" : " hits") : ray.truth();
  return judgement;
}

}  // namespace graze::compare
