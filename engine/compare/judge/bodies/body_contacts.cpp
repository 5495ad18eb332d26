#include <graze/engine/compare/judge/bodies/body_judges.h>
#include <graze/engine/compare/judge/bodies/body_parting.h>
#include <graze/engine/compare/judge/bodies/shape_bodies.h>
#include <graze/engine/compare/judge/rational/in_metres.h>
#include <graze/engine/work.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_bounds.h>

#include <algorithm>
#include <cmath>

namespace graze::compare {
namespace {

using Eigen::Vector3d;
using Fault = std::optional<WitnessFault>;

/// Normals are unit to some ulp.
constexpr double kUnitTolerance = 0x1p-48;

/// find_contacts() grants itself these shares: of how far the contacts lie apart, for what the
/// depth is short of parting the two; of the smaller shape, for the search of the least depth and
/// for where points lie; and of the depth, for points between boxes.
constexpr double kExtentTolerance = 1e-4;
constexpr double kSearchTolerance = 1e-6;
constexpr double kPointTolerance = 0x1p-18;
constexpr double kBoxShare = 0.05;

/// This share of the smaller shape is granted to other engines' contacts.
constexpr double kOthersTolerance = 1e-5;

/// A point that is off by more than this share of the smaller shape is wrong, though edges count as
/// one and round faces as octagons, whose sides are up to a thirteenth of the radius inside.
constexpr double kEdgeTolerance = 1.0 / 16;

double size_of(const PlacedBody& body) {
  const Aabb box = bounding_aabb({body.shape, body.pose});
  return (box.max - box.min).maxCoeff();
}

bool is(const PlacedBody& body, ShapeKind kind) {
  return body.shape.kind() == kind;
}

/// Returns the size of the smaller one that is bounded.
double smaller_size(const PlacedBody& a, const PlacedBody& b) {
  if (flat_of(a.shape)) return size_of(b);
  if (flat_of(b.shape)) return size_of(a);
  return std::min(size_of(a), size_of(b));
}

/// Checks the list: two convex bodies have one region, with up to four contacts.
Fault fault_of_list(const std::vector<CaseShapeContact>& contacts, bool are_convex) {
  if (are_convex && contacts.size() > 4) return WitnessFault{"more than four contacts", 0};
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const CaseShapeContact& c = contacts[i];
    const double off_unit = std::abs(c.normal.norm() - 1);
    if (!(off_unit <= kUnitTolerance)) return WitnessFault{"a normal of another length", off_unit};
    if (c.depth < 0) return WitnessFault{"a depth below zero", -c.depth};
    if (c.depth > contacts[0].depth)
      return WitnessFault{"a deeper contact after the first", c.depth - contacts[0].depth};
    for (std::size_t k = 0; k < i; ++k) {
      if (contacts[k].feature == c.feature) return WitnessFault{"a feature twice", 0};
    }
  }
  return std::nullopt;
}

double extent_of(const std::vector<CaseShapeContact>& contacts) {
  double extent = 0;
  for (const CaseShapeContact& c : contacts)
    extent = std::max(extent, (c.point - contacts[0].point).norm());
  return extent;
}

/// Checks that moving B by the greatest depth along the normal parts the two, and that not much
/// less does.
Fault fault_of_parting(const PlacedBody& a, const PlacedBody& b,
                       const std::vector<CaseShapeContact>& contacts, double tolerance) {
  const CaseShapeContact& deepest = contacts.front();
  const double needed = needed_along(a, b, deepest.normal);
  if (!(needed <= deepest.depth + tolerance)) {
    const double back = needed_along(a, b, -deepest.normal);
    if (back <= deepest.depth + tolerance)
      return WitnessFault{"a normal from B to A", 2 * deepest.depth};
    return WitnessFault{"a depth that does not part the two", needed - deepest.depth};
  }
  if (deepest.depth > std::max(needed, 0.0) + tolerance)
    return WitnessFault{"a depth beyond what parts the two", deepest.depth - needed};
  for (const CaseShapeContact& c : contacts) {
    const double aside = (c.normal - deepest.normal).norm();
    if (aside > kUnitTolerance) return WitnessFault{"normals that differ", aside};
  }
  return std::nullopt;
}

/// Reviews that for another engine's contacts, of which the deepest may stand anywhere. Along its
/// normal B may be free of A before a plane across it parts the two: both depths are ways out.
PartsReview review_others_parting(const PlacedBody& a, const PlacedBody& b,
                                  const CaseShapeContact& deepest, double tolerance,
                                  std::string& truth) {
  const Vector3d n = deepest.normal.normalized();
  const double needed = needed_along(a, b, n);
  const auto beside = [&](const char* what) {
    return std::string(what) + in_metres(", which is", deepest.depth) +
           in_metres(": a plane across the normal parts them after", needed);
  };
  if (deepest.depth > std::max(needed, 0.0) + tolerance) {
    return {.fault =
                WitnessFault{beside("a depth beyond what parts the two"), deepest.depth - needed}};
  }
  const WayOut way_out{n, std::max(deepest.depth, 0.0), tolerance};
  if (needed > deepest.depth + tolerance) {
    PartsReview parted = review_parted(a, b, way_out);
    const double back = needed_along(a, b, -n);
    if (parted.fault && back <= deepest.depth + tolerance)
      return {.fault = WitnessFault{"a normal from B to A", 2 * deepest.depth}};
    if (parted.fault)
      parted.fault->what =
          beside("a depth that does not part the two") + "; they are " + parted.fault->what;
    if (parted.fault || !parted.unjudged.empty()) return parted;
  }
  return review_least(a, b, way_out, truth);
}

/// Returns how far a point is off the surface, inside or outside.
double off_surface(const PlacedBody& body, const Vector3d& point) {
  return std::abs(outside_by(body.shape, body.pose, point));
}

/// Says how far a point of a contact is from where it must be, at least.
struct ShapePoint {
  const char* what;
  double off;
};

/// Returns the points of a contact. Each is midway between the surfaces along the normal. Near a
/// mesh the nearest surface may be another triangle's: there it is within the depth of both. Points
/// that are named lie on surfaces.
std::vector<ShapePoint> points_of(const PlacedBody& a, const PlacedBody& b,
                                  const std::vector<CaseShapeContact>& contacts, bool has_mesh) {
  std::vector<ShapePoint> points;
  for (const CaseShapeContact& c : contacts) {
    const Vector3d half = c.depth / 2 * c.normal;
    if (has_mesh) {
      points.push_back({"a point off A", outside_by(a.shape, a.pose, c.point) - c.depth});
      points.push_back({"a point off B", outside_by(b.shape, b.pose, c.point) - c.depth});
      continue;
    }
    points.push_back({"a point that is not midway", off_surface(a, c.point + half)});
    points.push_back({"a point that is not midway", off_surface(b, c.point - half)});
    if (c.point_a) points.push_back({"point_a is off A", off_surface(a, *c.point_a)});
    if (c.point_b) points.push_back({"point_b is off B", off_surface(b, *c.point_b)});
    if (!c.point_a || !c.point_b) continue;
    const Vector3d middle = *c.point_a / 2 + *c.point_b / 2;
    points.push_back({"a point that is not midway", (c.point - middle).norm()});
    const Vector3d between = *c.point_a - *c.point_b - 2 * half;
    points.push_back({"points that are not the depth apart", between.norm()});
  }
  return points;
}

}  // namespace

double needed_along(const PlacedBody& a, const PlacedBody& b, const Vector3d& n) {
  return support_along(a.shape, a.pose, n) + support_along(b.shape, b.pose, -n);
}

double parting_tolerance(const PlacedBody& a, const PlacedBody& b, bool is_graze) {
  const double size = smaller_size(a, b);
  return size * (is_graze ? kExtentTolerance + kSearchTolerance : kOthersTolerance) +
         kTouchUlps * 0x1p-52 * (a.pose.translation().norm() + b.pose.translation().norm() + size);
}

PartsReview review_manifold(const PlacedBody& a, const PlacedBody& b,
                            const std::vector<CaseShapeContact>& contacts, std::string& truth) {
  if (contacts.empty()) return {};
  const bool has_mesh = is_surface(a) || is_surface(b);
  if (Fault fault = fault_of_list(contacts, !has_mesh)) return {.fault = fault};
  const double size = smaller_size(a, b);
  const double slack =
      size * kSearchTolerance +
      kTouchUlps * 0x1p-52 * (a.pose.translation().norm() + b.pose.translation().norm() + size);
  const bool are_boxes = is(a, ShapeKind::Box) && is(b, ShapeKind::Box);
  const double beside =
      slack + kPointTolerance * size + (are_boxes ? kBoxShare * contacts[0].depth : 0);
  double most_off = 0;
  for (const ShapePoint& p : points_of(a, b, contacts, has_mesh)) {
    if (p.off > beside + kEdgeTolerance * size) return {.fault = WitnessFault{p.what, p.off}};
    most_off = std::max(most_off, p.off);
  }
  if (has_mesh) return {.unjudged = "normals and depths"};
  const double tolerance = slack + kExtentTolerance * extent_of(contacts);
  if (Fault fault = fault_of_parting(a, b, contacts, tolerance)) return {.fault = fault};
  const CaseShapeContact& deepest = contacts.front();
  const WayOut way_out{deepest.normal, deepest.depth, parting_tolerance(a, b, true)};
  PartsReview review = review_least(a, b, way_out, truth);
  if (!review.fault && most_off > beside) {
    const std::string points = "where its points are, to a part in 16";
    review.unjudged = review.unjudged.empty() ? points : points + ", and " + review.unjudged;
  }
  return review;
}

PartsReview review_others_contacts(const PlacedBody& a, const PlacedBody& b,
                                   const std::vector<CaseShapeContact>& contacts,
                                   std::string& truth) {
  if (contacts.empty()) return {};
  const double tolerance = parting_tolerance(a, b, false);
  const CaseShapeContact* deepest = contacts.data();
  for (const CaseShapeContact& c : contacts) {
    const double off_unit = std::abs(c.normal.norm() - 1);
    if (!(off_unit <= kOthersTolerance))
      return {.fault = WitnessFault{"a normal of another length", off_unit}};
    if (c.depth < -tolerance) return {.fault = WitnessFault{"a depth below zero", -c.depth}};
    for (const PlacedBody* body : {&a, &b}) {
      const double off =
          outside_by(body->shape, body->pose, c.point) - std::max(c.depth, 0.0) - tolerance;
      if (off > 0)
        return {.fault = WitnessFault{body == &a ? "a point off A" : "a point off B", off}};
    }
    if (c.depth > deepest->depth) deepest = &c;
  }
  if (is_surface(a) || is_surface(b)) return {.unjudged = "normals and depths"};
  return review_others_parting(a, b, *deepest, tolerance, truth);
}

}  // namespace graze::compare
