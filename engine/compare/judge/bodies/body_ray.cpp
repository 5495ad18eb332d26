#include <graze/engine/compare/judge/bodies/body_judges.h>
#include <graze/engine/compare/judge/bodies/shape_bodies.h>
#include <graze/engine/compare/judge/rational/in_metres.h>
#include <graze/engine/world/shape_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::compare {
namespace {

using Eigen::Vector3d;

constexpr double kTolerance = 0x1p-38;         // a share of the scale
constexpr double kUnitTolerance = 0x1p-48;     // the tolerance of normals
constexpr double kSupportTolerance = 0x1p-28;  // a share of the scale: it gives a normal to about
                                               // 1e-4
constexpr int kSteps = 200;                    // each step leaves two thirds of the interval

/// Returns the half-space behind a plane, as the ray's origin sees it.
CaseBody behind_plane(const CaseBody& body, const Ray& ray) {
  const auto* plane = body.shape.as<Plane>();
  if (plane == nullptr) return body;
  const Vector3d origin = body.pose.linear().transpose() * (ray.origin - body.pose.translation());
  const bool is_above = plane->normal.dot(origin) >= plane->offset;
  CaseBody half_space(is_above ? HalfSpace{plane->normal, plane->offset}
                               : HalfSpace{-plane->normal, -plane->offset},
                      body.pose);
  half_space.course = body.course;
  return half_space;
}

class BodyRay {
 public:
  BodyRay(const CaseBody& body, const Ray& ray)
      : body_(behind_plane(body, ray)), ray_(ray), direction_(ray.direction.stableNormalized()) {
    const double largest = ray.origin.norm() + body.pose.translation().norm();
    if (const auto* plane = body_.shape.as<HalfSpace>()) {
      scale_ = largest + std::abs(plane->offset);
      // Beyond this distance even a ray that comes in at an angle of 1e-12 has met it.
      most_ = 1e12 * (scale_ + 1);
    } else {
      const Aabb box = bounding_aabb({body.shape, body.pose});
      const double size = (box.max - box.min).norm();
      scale_ = size + (ray.origin - (box.min / 2 + box.max / 2)).norm();
      most_ = 2 * scale_;
    }
    most_ = std::min(most_, ray.max_distance);
    slack_ = kTolerance * scale_ + 64 * 0x1p-52 * largest;
    find_least();
  }

  /// Returns a level that is at most zero in the body, and convex along a ray.
  double level(double t) const {
    const Vector3d p = ray_.origin + t * direction_;
    const auto* egg = body_.shape.as<Ellipsoid>();
    if (egg == nullptr) return outside_by(body_.shape, body_.pose, p);
    const Vector3d q = body_.pose.linear().transpose() * (p - body_.pose.translation());
    const double ratio = (q - egg->centre).cwiseQuotient(egg->semi_axes).norm();
    return (ratio - 1) * egg->semi_axes.minCoeff();
  }

  bool is_sure_miss() const { return least_ > slack_; }
  bool is_sure_hit() const { return least_ < -slack_; }

  double entry() const {
    if (level(0) <= 0) return 0;
    double outside = 0;
    double inside = least_at_;
    for (int i = 0; i < kSteps; ++i) {
      const double middle = outside / 2 + inside / 2;
      (level(middle) > 0 ? outside : inside) = middle;
    }
    return inside;
  }

  std::optional<std::pair<std::string, double>> fault_of(const RayHit& hit) const {
    if (hit.triangle != kNoTriangle) return std::pair("a triangle of what has none", 0.0);
    if (hit.distance < 0) return std::pair("a distance below zero", -hit.distance);
    if (hit.distance > ray_.max_distance)
      return std::pair("a hit beyond the ray", hit.distance - ray_.max_distance);
    const double there = level(hit.distance);
    if (there > slack_) return std::pair("a point outside", there);
    if (hit.distance > 0 && there < -slack_) return std::pair("a point inside", -there);
    const double past = hit.distance - least_at_;
    if (past > slack_ && level(least_at_ + past / 2) < -slack_)
      return std::pair("where the ray leaves", past);
    const double off = (hit.point - (ray_.origin + hit.distance * direction_)).norm();
    if (off > slack_) return std::pair("another point", off);
    return fault_of_normal(hit);
  }

 private:
  std::optional<std::pair<std::string, double>> fault_of_normal(const RayHit& hit) const {
    const double off_unit = std::abs(hit.normal.norm() - 1);
    if (!(off_unit <= kUnitTolerance)) return std::pair("a normal of another length", off_unit);
    const double along = hit.normal.dot(direction_);
    if (along > kSupportTolerance) return std::pair("a normal along the ray", along);
    if (hit.distance == 0 && level(0) < -slack_) {  // then the ray begins inside
      const double off = (hit.normal + direction_).norm();
      if (off > kUnitTolerance) return std::pair("a normal that is not against the ray", off);
      return std::nullopt;
    }
    const double beyond =
        support_along(body_.shape, body_.pose, hit.normal) - hit.normal.dot(hit.point);
    if (!(beyond <= kSupportTolerance * scale_))
      return std::pair("a normal of another surface", beyond);
    return std::nullopt;
  }

  void find_least() {
    double first = 0;
    double last = most_;
    for (int i = 0; i < kSteps; ++i) {
      const double third = (last - first) / 3;
      if (level(first + third) < level(last - third)) {
        last -= third;
      } else {
        first += third;
      }
    }
    least_at_ = first / 2 + last / 2;
    for (const double t : {0.0, most_}) {
      if (level(t) < level(least_at_)) least_at_ = t;
    }
    least_ = level(least_at_);
  }

  CaseBody body_;
  const Ray& ray_;
  Vector3d direction_;
  double scale_ = 0;  ///< metres
  double most_ = 0;   ///< metres along the ray
  double slack_ = 0;  ///< metres
  double least_at_ = 0;
  double least_ = 0;
};

Judgement told(Verdict verdict, const std::string& truth, double error = 0) {
  Judgement judgement;
  judgement.verdict = verdict;
  judgement.truth = truth;
  judgement.error = error;
  return judgement;
}

}  // namespace

Judgement judge_body_ray(const CaseBody& body, const Ray& ray, const CaseAnswer& answer) {
  const BodyRay along(body, ray);
  const std::string truth = along.is_sure_miss()  ? "no hit"
                            : along.is_sure_hit() ? in_metres("hit after", along.entry())
                                                  : "it nearly touches";
  if (answer.hits->empty()) {
    if (along.is_sure_hit()) return told(Verdict::Wrong, truth);
    return told(along.is_sure_miss() ? Verdict::Right : Verdict::NotJudged, truth);
  }
  if (answer.hits->size() > 1) return told(Verdict::Wrong, truth + ", but more than the first");
  if (along.is_sure_miss()) return told(Verdict::Wrong, truth);
  if (const auto fault = along.fault_of(answer.hits->front()))
    return told(Verdict::Wrong, truth + ", but " + fault->first, fault->second);
  return told(along.is_sure_hit() ? Verdict::Right : Verdict::NotJudged, truth);
}

}  // namespace graze::compare
