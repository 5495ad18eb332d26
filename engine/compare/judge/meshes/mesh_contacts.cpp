#include <graze/engine/compare/judge/meshes/mesh_reviews.h>
#include <graze/engine/compare/judge/meshes/pair_error.h>
#include <graze/engine/compare/judge/rational/mesh_referee.h>
#include <graze/engine/mesh/placement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace graze::compare {
namespace {

using Eigen::Vector3d;
using Fault = std::optional<WitnessFault>;

/// Engines other than graze add up some tens of roundings of floats, 6e-8 each.
constexpr double kFloatTolerance = 1e-5;

/// graze's normals are unit to 2 ulp.
constexpr double kUnitTolerance = 0x1p-50;

/// This is a share of the largest coordinate: what separating_translation() adds to a last contact
/// is some 2^-50 of it over the cosine between the direction and the normals of the surfaces, here
/// up to 2^12.
constexpr double kDepthTolerance = 0x1p-38;

/// No vertex of a convex surface is farther before a face than this share of the size.
constexpr double kFlatTolerance = 1e-12;

/// A pair of triangles may give so many contacts, in engines that ask each pair.
constexpr std::size_t kMostOfPair = 8;

/// More vertices times faces than this are not looked at.
constexpr std::size_t kMostTests = 100000000;

enum class ContactConvention {
  Graze,          ///< find_contacts()
  TrianglePairs,  ///< contacts of each pair of triangles that hit
  Unknown,
};

bool is_convex(const Mesh& mesh) {
  if (!mesh.topology().is_closed) return false;
  if (mesh.vertices().size() * mesh.triangles().size() > kMostTests) return false;
  const double size = (mesh.bounds().max - mesh.bounds().min).maxCoeff();
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    const Triangle t = mesh.triangle(i);
    const Vector3d normal = (t.b - t.a).cross(t.c - t.a).normalized();
    for (const Vector3d& v : mesh.vertices()) {
      if (normal.dot(v - t.a) > kFlatTolerance * size) return false;
    }
  }
  return true;
}

/// Returns all numbers of a contact, to find those that are given more than once.
std::array<double, 13> numbers_of(const CaseContact& c) {
  return {c.point.x(),   c.point.y(),   c.point.z(),   c.point_a.x(), c.point_a.y(),
          c.point_a.z(), c.point_b.x(), c.point_b.y(), c.point_b.z(), c.normal.x(),
          c.normal.y(),  c.normal.z(),  c.depth};
}

bool has_repeats(const std::vector<CaseContact>& contacts) {
  std::set<std::array<double, 13>> known;
  return std::any_of(contacts.begin(), contacts.end(),
                     [&](const CaseContact& c) { return !known.insert(numbers_of(c)).second; });
}

/// Tells by which convention an engine gives contacts. Some give them for each pair of triangles,
/// without the pair: the same contact may come once for each, and its normal and depth are those of
/// two triangles. A wrapper of such an engine has another name, but is known by repeating itself.
ContactConvention convention_of(const std::string& engine,
                                const std::vector<CaseContact>& contacts) {
  if (engine == "graze") return ContactConvention::Graze;
  const bool is_of_pairs =
      engine == "fcl" || engine == "bullet" || engine == "ode" || engine == "coal";
  return is_of_pairs || has_repeats(contacts) ? ContactConvention::TrianglePairs
                                              : ContactConvention::Unknown;
}

double off_bounds(std::initializer_list<Triangle> triangles, const Vector3d& p) {
  Vector3d min = triangles.begin()->a;
  Vector3d max = min;
  for (const Triangle& t : triangles) {
    min = min.cwiseMin(t.a).cwiseMin(t.b).cwiseMin(t.c);
    max = max.cwiseMax(t.a).cwiseMax(t.b).cwiseMax(t.c);
  }
  return (min - p).cwiseMax(p - max).maxCoeff();
}

class ContactReview {
 public:
  ContactReview(const MeshReferee& referee, const std::vector<TrianglePair>& hits,
                const MeshCase& meshes, ContactConvention convention)
      : referee_(referee),
        hits_(hits),
        meshes_(meshes),
        convention_(convention),
        is_graze_(convention == ContactConvention::Graze),
        largest_(largest_coordinate(referee)),
        exact_(kTouchUlps *
               (std::nextafter(largest_, std::numeric_limits<double>::infinity()) - largest_)),
        slack_(is_graze_ ? kDepthTolerance * largest_ : kFloatTolerance * largest_) {}

  Fault fault_of(const CaseContact& c) const {
    const double off_unit = std::abs(c.normal.norm() - 1);
    if (!(off_unit <= (is_graze_ ? kUnitTolerance : kFloatTolerance)))
      return WitnessFault{"a normal of another length", off_unit};
    if (c.depth < (is_graze_ ? 0 : -slack_)) return WitnessFault{"a depth below zero", -c.depth};
    const double along = overlap_along(referee_, c.normal);
    const double most = is_graze_ ? along : std::max(along, overlap_along(referee_, -c.normal));
    if (c.depth > std::max(most, 0.0) + slack_)
      return WitnessFault{"a depth beyond both meshes", c.depth - most};
    const double width = (c.point_a - c.point_b).dot(c.normal);
    const bool names_both = is_graze_ || c.point_a != c.point_b;
    if (names_both && c.depth > width + slack_) {
      return WitnessFault{"points less far past each other along the normal than it is deep",
                          c.depth - width};
    }
    return is_graze_ ? fault_of_ours(c, width) : fault_of_place(c);
  }

  /// Finds contacts that are the same in every bit. Surfaces that lie on themselves may touch in
  /// one point more than once: for meshes that are not convex graze may say so once for a pair of
  /// triangles.
  Fault fault_of_repeats(const std::vector<CaseContact>& contacts, bool are_convex) const {
    std::map<std::array<double, 13>, std::size_t> counts;
    for (const CaseContact& c : contacts) {
      const std::size_t count = ++counts[numbers_of(c)];
      if (count > 1 && !may_repeat(c, count, are_convex))
        return WitnessFault{"the same contact " + std::to_string(count) + " times", 0};
    }
    return std::nullopt;
  }

  /// Says by a plane across the normal whether moving B by the depth parts two convex meshes.
  bool is_parted_by(const CaseContact& c, double sign) const {
    return overlap_along(referee_, sign * c.normal) <= c.depth + slack_;
  }

 private:
  /// Checks what find_contacts() promises: `point` is midway between `point_a`, on A, and
  /// `point_b`, on B; the depth is the width between these, or less if that alone parts the two.
  Fault fault_of_ours(const CaseContact& c, double width) const {
    const double off_a = distance_to(referee_.triangles_a(), c.point_a);
    if (off_a > exact_) return WitnessFault{"point_a is off the surface of A", off_a};
    const double off_b = distance_to(referee_.triangles_b(), c.point_b);
    if (off_b > exact_) return WitnessFault{"point_b is off the surface of B", off_b};
    const double off_middle = (c.point - (c.point_a / 2 + c.point_b / 2)).norm();
    if (off_middle > exact_)
      return WitnessFault{"a point that is not midway between the two", off_middle};
    if (c.depth >= width - slack_) return std::nullopt;
    const double needed = c.depth + slack_;
    if (is_hit_after(needed * c.normal))
      return WitnessFault{"a depth that is neither the width nor parts the meshes",
                          width - c.depth};
    const double enough = c.depth - 0x1p-20 * width - slack_;
    if (enough > 0 && !is_hit_after(enough * c.normal))
      return WitnessFault{"a depth that is neither the width nor the last contact",
                          width - c.depth};
    return std::nullopt;
  }

  /// Checks the place of others' points, by which they mean many things: it belongs to a pair of
  /// triangles that hit.
  Fault fault_of_place(const CaseContact& c) const {
    double least = std::numeric_limits<double>::infinity();
    for (const TrianglePair& pair : hits_)
      least = std::min(
          least, off_bounds({referee_.triangle_a(pair.a), referee_.triangle_b(pair.b)}, c.point));
    const double beyond = least - c.depth;
    if (beyond <= slack_) return std::nullopt;
    return WitnessFault{"a point away from all triangles that hit", beyond};
  }

  bool may_repeat(const CaseContact& c, std::size_t count, bool are_convex) const {
    if (convention_ == ContactConvention::TrianglePairs)
      return count <= kMostOfPair * hits_.size() || count <= kMostOfPair * pairs_near(c.point);
    if (!is_graze_ || are_convex || c.depth > 0) return false;
    return count <= static_cast<std::size_t>(
                        std::count_if(hits_.begin(), hits_.end(), [&](const TrianglePair& pair) {
                          return off_bounds({referee_.triangle_a(pair.a)}, c.point) <= exact_ &&
                                 off_bounds({referee_.triangle_b(pair.b)}, c.point) <= exact_;
                        }));
  }

  /// Returns how many pairs of triangles may touch at a point, within what engines round: around a
  /// vertex many, of which few do.
  std::size_t pairs_near(const Vector3d& p) const {
    const auto count = [&](const std::vector<Triangle>& triangles) {
      return static_cast<std::size_t>(
          std::count_if(triangles.begin(), triangles.end(),
                        [&](const Triangle& t) { return off_bounds({t}, p) <= slack_; }));
    };
    return count(referee_.triangles_a()) * count(referee_.triangles_b());
  }

  bool is_hit_after(const Vector3d& translation) const {
    Pose moved = meshes_.b.pose;
    moved.translation() += translation;
    return MeshReferee({meshes_.a.mesh, meshes_.a.pose}, {meshes_.b.mesh, moved})
        .find_hit()
        .has_value();
  }

  const MeshReferee& referee_;
  const std::vector<TrianglePair>& hits_;
  const MeshCase& meshes_;
  ContactConvention convention_;
  bool is_graze_;
  double largest_;  ///< the largest coordinate, metres
  double exact_;    ///< metres
  double slack_;    ///< metres
};

}  // namespace

PartsReview review_contacts(const MeshReferee& referee, const std::vector<TrianglePair>& hits,
                            const MeshCase& meshes, const std::vector<CaseContact>& contacts,
                            const std::string& engine) {
  const ContactConvention convention = convention_of(engine, contacts);
  const ContactReview review(referee, hits, meshes, convention);
  for (const CaseContact& c : contacts) {
    if (Fault fault = review.fault_of(c)) return {.fault = fault};
  }
  const bool are_convex = is_convex(meshes.a.mesh) && is_convex(meshes.b.mesh);
  if (Fault fault = review.fault_of_repeats(contacts, are_convex)) return {.fault = fault};
  const bool is_of_pairs = convention == ContactConvention::TrianglePairs;
  if (are_convex) {
    std::size_t parting = 0, reversed = 0;
    double error = 0;
    for (const CaseContact& c : contacts) {
      const bool does_part = review.is_parted_by(c, 1);
      parting += does_part;
      if (does_part || !review.is_parted_by(c, -1)) continue;
      ++reversed;
      error = 2 * c.depth;
    }
    // Where one touches a side of the other from within, both ways may be as long: that contact
    // leads out through the side, the way back out of the whole.
    if (parting == 0 && reversed == contacts.size())
      return {.fault = WitnessFault{"a normal from B to A", error}};
    const bool is_judged =
        convention == ContactConvention::Graze ? parting > 0 : parting == contacts.size();
    if (is_judged && !is_of_pairs) return {};
  }
  return {.unjudged = convention == ContactConvention::Graze
                          ? "normals, and which parts are in touch"
                          : "normals, depths, and which points are meant"};
}

}  // namespace graze::compare
