// Asks Coal 3 through the interface that every engine has: OBBRSS trees and shapes, in double. Its
// settings are its defaults, but for the one that asks for time and changes no answer (slack_of).

#include <graze/engine/compare/peers/adaptors.h>
#include <graze/engine/compare/peers/shape_answers.h>
#include <graze/engine/world/shapes/hull_data.h>
#include <graze/narrowphase/convex/core/hull.h>

#include <coal/BVH/BVH_model.h>
#include <coal/collision.h>
#include <coal/distance.h>
#include <coal/shape/convex.h>
#include <coal/shape/geometric_shapes.h>
#include <algorithm>
#include <cmath>
#include <coal/config.hh>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

// The linked library was compiled for the baseline, as FCL was.
static_assert(EIGEN_MAX_ALIGN_BYTES == 16, "compile this file without -march or -mavx flags");

namespace graze::compare {
namespace {

using Geometry = std::shared_ptr<coal::CollisionGeometry>;
using Points = std::vector<Eigen::Vector3d>;

coal::Transform3s to_coal(const Pose& pose, const Eigen::Vector3d& centre = {0, 0, 0}) {
  return {Eigen::Matrix3d(pose.linear()), Eigen::Vector3d(pose * centre)};
}

void check(int code, const char* step) {
  if (code != coal::BVH_OK) {
    throw MeshError(std::string("Coal refuses the mesh: ") + step + " returned " +
                    std::to_string(code));
  }
}

Geometry coal_mesh(const Mesh& mesh) {
  std::vector<coal::Triangle> triangles;
  triangles.reserve(mesh.triangles().size());
  for (const TriangleIndices& t : mesh.triangles())
    triangles.emplace_back(t[0], t[1], t[2]);
  auto model = std::make_shared<coal::BVHModel<coal::OBBRSS>>();
  check(model->beginModel(static_cast<unsigned>(triangles.size()),
                          static_cast<unsigned>(mesh.vertices().size())),
        "beginModel");
  check(model->addSubModel(Points(mesh.vertices().begin(), mesh.vertices().end()), triangles),
        "addSubModel");
  check(model->endModel(), "endModel");
  return model;
}

/// Returns the geometry with the box that bounding_radius_of() asks for.
Geometry measured(Geometry geometry) {
  geometry->computeLocalAABB();
  return geometry;
}

/// Returns what Coal says, or nothing where it throws: it has no function for the two, or its
/// search ended where it should not.
template <typename Query>
auto unless_it_throws(const Query& query) -> std::optional<decltype(query())> {
  try {
    return query();
  } catch (const std::logic_error&) {
    return std::nullopt;
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

/// Returns a bound of how far points of the geometry are from the origin of the common frame.
double bounding_radius_of(const coal::CollisionGeometry& geometry, const coal::Transform3s& pose) {
  return pose.getTranslation().norm() + geometry.aabb_center.norm() + geometry.aabb_radius;
}

/// Returns how far apart boxes may be and still be opened. Coal's default is a millimetre whatever
/// the size of things, which takes many times as long for the same answers; with none at all the
/// rounding of its boxes loses pairs that touch.
double slack_of(double radius) {
  return 0x1p-40 * radius;
}

coal::CollisionResult collide(const coal::CollisionGeometry& a, const coal::Transform3s& pose_a,
                              const coal::CollisionGeometry& b, const coal::Transform3s& pose_b,
                              std::size_t max_contacts) {
  coal::CollisionRequest request(coal::CONTACT, max_contacts);
  request.break_distance =
      slack_of(std::max(bounding_radius_of(a, pose_a), bounding_radius_of(b, pose_b)));
  coal::CollisionResult result;
  coal::collide(&a, pose_a, &b, pose_b, request, result);
  return result;
}

class CoalPair : public LoadedPair {
 public:
  CoalPair(const Mesh& mesh_a, const Mesh& mesh_b)
      : mesh_a_(measured(coal_mesh(mesh_a))), mesh_b_(measured(coal_mesh(mesh_b))) {}

  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    if (!question.is_plain()) return std::nullopt;
    return unless_it_throws([&] { return known_answer(question, pose_a, pose_b); })
        .value_or(std::nullopt);
  }

 private:
  std::optional<CaseAnswer> known_answer(const Question& question, const Pose& pose_a,
                                         const Pose& pose_b) const {
    constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
    CaseAnswer answer;
    switch (question.ask) {
      case Ask::Any:
        answer.says = contacts(pose_a, pose_b, 1).isCollision();
        return answer;
      case Ask::Pairs:
        answer.pairs = pairs_of(contacts(pose_a, pose_b, kAll));
        return answer;
      case Ask::Contacts:
        answer.contacts = contacts_of(contacts(pose_a, pose_b, kAll));
        if (!answer.contacts) return std::nullopt;
        return answer;
      case Ask::Distance: {
        const coal::DistanceResult gap = distance(pose_a, pose_b);
        answer.distance = gap.min_distance;
        if (gap.b1 >= 0 && gap.b2 >= 0) answer.pair = pair_of(gap);
        return answer;
      }
      case Ask::Within:
        answer.says = distance(pose_a, pose_b).min_distance <= question.settings.clearance;
        return answer;
      default:
        return std::nullopt;
    }
  }

  coal::CollisionResult contacts(const Pose& pose_a, const Pose& pose_b, std::size_t most) const {
    return collide(*mesh_a_, to_coal(pose_a), *mesh_b_, to_coal(pose_b), most);
  }

  /// Returns the distance; that of two meshes that meet is 0, and no depth.
  coal::DistanceResult distance(const Pose& pose_a, const Pose& pose_b) const {
    const coal::DistanceRequest request;
    coal::DistanceResult result;
    coal::distance(mesh_a_.get(), to_coal(pose_a), mesh_b_.get(), to_coal(pose_b), request, result);
    return result;
  }

  /// Returns the pair. Coal keeps the order of the triangles: b1 and b2 are the mesh's own indices.
  template <typename Found>
  static TrianglePair pair_of(const Found& found) {
    return {static_cast<std::uint32_t>(found.b1), static_cast<std::uint32_t>(found.b2)};
  }

  static std::vector<TrianglePair> pairs_of(const coal::CollisionResult& result) {
    std::vector<TrianglePair> pairs;
    pairs.reserve(result.numContacts());
    for (const coal::Contact& contact : result.getContacts())
      pairs.push_back(pair_of(contact));
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  /// Returns contacts; nothing if some have NaN, as happens beyond 1e100 m: no file could keep
  /// them.
  static std::optional<std::vector<CaseContact>> contacts_of(const coal::CollisionResult& result) {
    std::vector<CaseContact> contacts;
    contacts.reserve(result.numContacts());
    for (const coal::Contact& c : result.getContacts()) {
      const bool is_finite = c.pos.allFinite() && c.nearest_points[0].allFinite() &&
                             c.nearest_points[1].allFinite() && c.normal.allFinite() &&
                             std::isfinite(c.penetration_depth);
      if (!is_finite) return std::nullopt;
      contacts.push_back(
          {c.pos, c.nearest_points[0], c.nearest_points[1], c.normal, -c.penetration_depth});
    }
    return contacts;
  }

  Geometry mesh_a_;
  Geometry mesh_b_;
};

/// Adds triangles to and fro across the face, so that none of its corners gets many neighbours.
void add_strip(std::span<const std::uint32_t> loop, std::vector<coal::Triangle>& triangles) {
  std::size_t first = 0;
  std::size_t last = loop.size() - 1;
  for (bool is_at_first = true; first + 1 < last; is_at_first = !is_at_first) {
    triangles.emplace_back(loop[first], loop[is_at_first ? first + 1 : last - 1], loop[last]);
    is_at_first ? ++first : --last;
  }
}

/// Makes Coal's shapes, with whole lengths where graze's are half.
struct MakeGeometry {
  Geometry operator()(const Sphere& s) const { return std::make_shared<coal::Sphere>(s.radius); }
  Geometry operator()(const Box& s) const {
    return std::make_shared<coal::Box>(Eigen::Vector3d(2 * s.half_extents));
  }
  Geometry operator()(const Capsule& s) const {
    return std::make_shared<coal::Capsule>(s.radius, 2 * s.half_length);
  }
  Geometry operator()(const Cylinder& s) const {
    return std::make_shared<coal::Cylinder>(s.radius, 2 * s.half_height);
  }
  Geometry operator()(const Cone& s) const {
    return std::make_shared<coal::Cone>(s.radius, 2 * s.half_height);
  }
  Geometry operator()(const Ellipsoid& s) const {
    return std::make_shared<coal::Ellipsoid>(s.semi_axes);
  }
  Geometry operator()(const HalfSpace& s) const {
    return std::make_shared<coal::Halfspace>(s.normal, s.offset);
  }
  Geometry operator()(const Plane& s) const {
    return std::make_shared<coal::Plane>(s.normal, s.offset);
  }
  Geometry operator()(const Mesh& s) const { return coal_mesh(s); }
  Geometry operator()(const HeightField& s) const { return coal_mesh(s.mesh()); }
  Geometry operator()(const ConvexHull& s) const {
    const narrowphase::Hull& hull = data_of(s);
    auto points = std::make_shared<Points>();
    for (const auto& c : hull.corners)
      points->emplace_back(c.x, c.y, c.z);
    auto triangles = std::make_shared<std::vector<coal::Triangle>>();
    for (const auto& face : hull.faces)
      add_strip({&hull.loops[face.first], face.count}, *triangles);
    return std::make_shared<coal::Convex<coal::Triangle>>(
        points, static_cast<unsigned>(points->size()), triangles,
        static_cast<unsigned>(triangles->size()));
  }
};

/// Returns a geometry; null for what Coal refuses: a hull with a corner of 255 neighbours or more.
Geometry geometry_of(const Shape& shape) {
  return unless_it_throws([&] { return measured(std::visit(MakeGeometry(), shape.value())); })
      .value_or(nullptr);
}

Eigen::Vector3d centre_of(const Shape& shape) {
  if (const auto* ball = shape.as<Sphere>()) return ball->centre;
  if (const auto* egg = shape.as<Ellipsoid>()) return egg->centre;
  const auto* hull = shape.as<ConvexHull>();
  if (hull == nullptr) return {0, 0, 0};
  const narrowphase::Vec3& middle = data_of(*hull).middle;
  return {middle.x, middle.y, middle.z};
}

class CoalShapes : public LoadedShapes {
 public:
  explicit CoalShapes(std::span<const Shape> shapes) {
    for (const Shape& shape : shapes) {
      shapes_.push_back({geometry_of(shape), centre_of(shape)});
    }
  }

  std::optional<bool> intersects(std::size_t shape_a, const Pose& pose_a, std::size_t shape_b,
                                 const Pose& pose_b) const override {
    const Body& a = shapes_[shape_a];
    const Body& b = shapes_[shape_b];
    if (a.geometry == nullptr || b.geometry == nullptr) return std::nullopt;
    return unless_it_throws([&] {
      return collide(*a.geometry, to_coal(pose_a, a.centre), *b.geometry, to_coal(pose_b, b.centre),
                     1)
          .isCollision();
    });
  }

  std::optional<CaseAnswer> answer(const Question& question, const PlacedShape& a,
                                   const PlacedShape& b) const override {
    if (shapes_[a.shape].geometry == nullptr || shapes_[b.shape].geometry == nullptr)
      return std::nullopt;
    return unless_it_throws([&] { return known_answer(question, a, b); }).value_or(std::nullopt);
  }

 private:
  std::optional<CaseAnswer> known_answer(const Question& question, const PlacedShape& a,
                                         const PlacedShape& b) const {
    switch (question.ask) {
      case Ask::Distance:
        return answer_of_distance(distance(a, b));
      case Ask::Within:
        return answer_of_within(distance(a, b), question.settings.clearance);
      case Ask::Contacts:
        return contacts(a, b);
      case Ask::Separation:
        return answer_of_separation(*contacts(a, b).manifold);
      default:
        return std::nullopt;
    }
  }

  /// Returns the distance; below 0 they are as deep as that.
  std::optional<double> distance(const PlacedShape& a, const PlacedShape& b) const {
    const coal::DistanceRequest request;
    coal::DistanceResult result;
    const Body& body_a = shapes_[a.shape];
    const Body& body_b = shapes_[b.shape];
    coal::distance(body_a.geometry.get(), to_coal(a.pose, body_a.centre), body_b.geometry.get(),
                   to_coal(b.pose, body_b.centre), request, result);
    return result.min_distance;
  }

  CaseAnswer contacts(const PlacedShape& a, const PlacedShape& b) const {
    constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
    const Body& body_a = shapes_[a.shape];
    const Body& body_b = shapes_[b.shape];
    const coal::CollisionResult result =
        collide(*body_a.geometry, to_coal(a.pose, body_a.centre), *body_b.geometry,
                to_coal(b.pose, body_b.centre), kAll);
    CaseAnswer answer;
    answer.manifold.emplace();
    for (const coal::Contact& c : result.getContacts())
      add_contact(c.pos, c.normal, -c.penetration_depth, *answer.manifold);
    return answer;
  }

  struct Body {
    Geometry geometry;       ///< the geometry, or null
    Eigen::Vector3d centre;  ///< Coal's shapes are at 0
  };
  std::vector<Body> shapes_;
};

class CoalEngine : public Engine {
 public:
  CaseWitness name() const override { return {"coal", COAL_VERSION}; }
  std::optional<double> tolerance() const override { return 1e-6; }  // README.md
  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    return std::make_unique<CoalPair>(mesh_a, mesh_b);
  }
  std::unique_ptr<LoadedShapes> load_shapes(std::span<const Shape> shapes) const override {
    return std::make_unique<CoalShapes>(shapes);
  }
};

}  // namespace

std::unique_ptr<Engine> make_coal_engine() {
  return std::make_unique<CoalEngine>();
}

}  // namespace graze::compare
