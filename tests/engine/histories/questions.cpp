#include "tests/engine/histories/questions.h"

#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shape_ray.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "tests/engine/histories/swept_contacts.h"

namespace graze::tests {
namespace {

bool are_equal(const ShapeDistance& s, const ShapeDistance& t) {
  return s.distance == t.distance && s.lower_bound == t.lower_bound && s.point_a == t.point_a &&
         s.point_b == t.point_b && s.normal == t.normal && s.status == t.status;
}

bool are_equal(const RayHit& s, const RayHit& t) {
  return s.distance == t.distance && s.point == t.point && s.normal == t.normal &&
         s.triangle == t.triangle;
}

/// Bodies by id, as the world lists them, and what a query is about.
class Asked {
 public:
  Asked(const World& world, const Oracle& oracle, const std::map<BodyId, std::uint32_t>& names,
        const BodyQuerySettings& settings)
      : world_(world), oracle_(oracle), settings_(settings) {
    std::size_t count = 0;
    for (const auto& [id, name] : names) {
      if (!oracle.has(name) || !world.contains(id) || world.user_data(id) != name) continue;
      ++count;
      if (may_ask(oracle.beings().at(name).filter)) bodies_.push_back({id, name});
    }
    expect(count == oracle.beings().size(), "bodies are missing");
  }

  std::size_t touching(const Shape& shape, const Pose& pose) const {
    std::vector<BodyId> wanted;
    for (const auto& [id, name] : bodies_) {
      bool is_hit = false;
      for_pieces(name, [&](const Piece& piece) {
        is_hit = is_hit || intersects({shape, pose}, oracle_.placed(piece));
      });
      if (is_hit) wanted.push_back(id);
    }
    expect(world_.find_touching({shape, pose}, settings_) == wanted, "find_touching() differs");
    return wanted.size();
  }

  std::size_t within(const Shape& shape, const Pose& pose, double clearance) const {
    std::vector<BodyDistance> wanted;
    for (const Known& body : bodies_) {
      const std::optional<BodyDistance> gap = nearest(body, {shape, pose});
      if (gap && gap->distance.distance <= clearance) wanted.push_back(*gap);
    }
    const std::vector<BodyDistance> found = world_.find_within({shape, pose}, clearance, settings_);
    expect(std::equal(found.begin(), found.end(), wanted.begin(), wanted.end(), are_same),
           "find_within() differs: " + std::to_string(found.size()) + " bodies, not " +
               std::to_string(wanted.size()));
    return wanted.size();
  }

  std::size_t closest(const Shape& shape, const Pose& pose) const {
    std::optional<BodyDistance> wanted;
    for (const Known& body : bodies_) {
      const std::optional<BodyDistance> gap = nearest(body, {shape, pose});
      if (gap && (!wanted || gap->distance.distance < wanted->distance.distance)) wanted = gap;
    }
    const std::optional<BodyDistance> found = world_.find_closest({shape, pose}, settings_);
    expect(found.has_value() == wanted.has_value(), "find_closest() differs");
    expect(!found || are_same(*found, *wanted),
           "find_closest() finds another body or part, or says otherwise how far it is");
    return wanted ? 1 : 0;
  }

  std::size_t ray(const Ray& ray) const {
    std::vector<BodyRayHit> wanted;
    for (const auto& [id, name] : bodies_) {
      std::optional<BodyRayHit> first;
      for_pieces(name, [&, body = id](const Piece& piece) {
        const auto hit = graze::cast_ray(oracle_.placed(piece), ray);
        if (hit && (!first || hit->distance < first->hit.distance))
          first = BodyRayHit{body, *hit, piece.number};
      });
      if (first) wanted.push_back(*first);
    }
    std::sort(wanted.begin(), wanted.end(), [](const BodyRayHit& s, const BodyRayHit& t) {
      return std::tie(s.hit.distance, s.id) < std::tie(t.hit.distance, t.id);
    });
    const auto is_same = [](const BodyRayHit& s, const BodyRayHit& t) {
      return s.id == t.id && s.part == t.part && are_equal(s.hit, t.hit);
    };
    const std::vector<BodyRayHit> found = world_.cast_ray_all(ray, settings_);
    expect(std::equal(found.begin(), found.end(), wanted.begin(), wanted.end(), is_same),
           "cast_ray_all() differs: " + std::to_string(found.size()) + " bodies, not " +
               std::to_string(wanted.size()));
    const std::optional<BodyRayHit> first = world_.cast_ray(ray, settings_);
    expect(first.has_value() == !wanted.empty() && (!first || is_same(*first, wanted[0])),
           "cast_ray() differs");
    return wanted.size();
  }

  std::size_t box(const Aabb& box) const {
    std::vector<BodyId> wanted;
    for (const auto& [id, name] : bodies_) {
      const Aabb own = oracle_.box_of(name);
      bool is_there = true;
      for (int k = 0; k < 3; ++k)
        is_there = is_there && own.min[k] <= box.max[k] && box.min[k] <= own.max[k];
      if (is_there) wanted.push_back(id);
    }
    expect(world_.find_in_box(box, settings_) == wanted, "find_in_box() differs");
    return wanted.size();
  }

  /// Of all pairs that may meet, A being the body of the smaller id. Boxes that are farther apart
  /// than the nearest need not be asked: distance() never says less than they do.
  std::size_t closest_pair() const {
    std::optional<BodyPairDistance> wanted;
    for (const Known& a : bodies_) {
      for (const Known& b : bodies_) {
        if (!(a.id < b.id) || !oracle_.may_meet(ordered(a.name, b.name))) continue;
        for_pairs(a.name, b.name, [&](const Piece& s, const Piece& t) {
          const PlacedShapeView placed_s = oracle_.placed(s), placed_t = oracle_.placed(t);
          const double most = wanted ? wanted->distance.distance : 0;
          if (wanted && widest_gap(bounding_aabb(placed_s), bounding_aabb(placed_t)) > most) return;
          const ShapeDistance gap = distance(placed_s, placed_t);
          if (!wanted || gap.distance < most)
            wanted = BodyPairDistance{a.id, b.id, gap, s.number, t.number};
        });
      }
    }
    const std::optional<BodyPairDistance> found = world_.find_closest_pair();
    expect(found.has_value() == wanted.has_value(), "find_closest_pair() differs");
    expect(!found ||
               (found->a == wanted->a && found->b == wanted->b && found->part_a == wanted->part_a &&
                found->part_b == wanted->part_b && are_equal(found->distance, wanted->distance)),
           "find_closest_pair() finds other bodies or parts, or says otherwise how far they are");
    return wanted ? 1 : 0;
  }

  /// To whom a shape comes: of each body the part that is first.
  std::size_t cast(const Shape& shape, const RigidMotion& motion,
                   const RigidContactSettings& contact) const {
    if (is_endless(shape)) return 0;
    std::vector<BodyCast> wanted;
    for (const Known& body : bodies_) {
      const RigidMotion rest(oracle_.beings().at(body.name).pose);
      const bool has_parts = oracle_.beings().at(body.name).parts.has_value();
      std::optional<BodyCast> first;
      for_pieces(body.name, [&](const Piece& piece) {
        const RigidMotion own = has_parts ? motion_of_part(rest, piece.pose) : rest;
        const auto met =
            contact_in_motion({shape, motion}, {oracle_.palette()[piece.shape], own}, contact);
        expect(met.has_value(), "a motion is refused");
        if (met->status != RigidStatus::Free && (!first || met->low < first->contact.low))
          first = BodyCast{body.id, *met, piece.number};
      });
      if (first) wanted.push_back(*first);
    }
    std::sort(wanted.begin(), wanted.end(), [](const BodyCast& s, const BodyCast& t) {
      return std::tie(s.contact.low, s.id) < std::tie(t.contact.low, t.id);
    });
    const std::vector<BodyCast> found = world_.cast_all({shape, motion}, contact, settings_);
    expect(found == wanted, "cast_all() differs: " + std::to_string(found.size()) +
                                " bodies, not " + std::to_string(wanted.size()));
    const std::optional<BodyCast> first = world_.cast({shape, motion}, contact, settings_);
    expect(first.has_value() == !wanted.empty() && (!first || *first == wanted[0]),
           "cast() differs");
    return wanted.size();
  }

 private:
  struct Known {
    BodyId id;
    std::uint32_t name;
  };

  static bool are_same(const BodyDistance& s, const BodyDistance& t) {
    return s.id == t.id && s.part == t.part && are_equal(s.distance, t.distance);
  }

  bool may_ask(const Filter& filter) const {
    return !settings_.filter || lets_pass(*settings_.filter, filter);
  }

  template <typename Visit>
  void for_pieces(std::uint32_t name, const Visit& visit) const {
    for (const Piece& piece : oracle_.pieces_of(name)) {
      if (!piece.filter || may_ask(*piece.filter)) visit(piece);
    }
  }

  template <typename Visit>
  void for_pairs(std::uint32_t a, std::uint32_t b, const Visit& visit) const {
    for (const Piece& s : oracle_.pieces_of(a)) {
      for (const Piece& t : oracle_.pieces_of(b)) {
        if (a < b ? oracle_.may_meet({a, b}, s, t) : oracle_.may_meet({b, a}, t, s)) visit(s, t);
      }
    }
  }

  /// The largest along an axis, less what the boxes may be rounded by.
  static double widest_gap(const Aabb& s, const Aabb& t) {
    double widest = 0;
    for (int k = 0; k < 3; ++k)
      widest = std::max({widest, s.min[k] - t.max[k], t.min[k] - s.max[k]});
    return widest * (1 - 0x1p-40);
  }

  /// Its nearest piece, of equals the first.
  std::optional<BodyDistance> nearest(const Known& body, const PlacedShapeView& shape) const {
    std::optional<BodyDistance> best;
    for_pieces(body.name, [&](const Piece& piece) {
      const ShapeDistance gap = distance(shape, oracle_.placed(piece));
      if (!best || gap.distance < best->distance.distance)
        best = BodyDistance{body.id, gap, piece.number};
    });
    return best;
  }

  const World& world_;
  const Oracle& oracle_;
  const BodyQuerySettings& settings_;
  std::vector<Known> bodies_;  // those that are asked for, ascending
};

std::size_t check_one(const Operation& question, const Asked& asked, const Oracle& oracle) {
  const auto vector = [&](std::size_t i) {
    return Eigen::Vector3d(question.values[i], question.values[i + 1], question.values[i + 2]);
  };
  switch (question.verb) {
    case Verb::AskRay:
      return asked.ray({vector(0), vector(3), question.values[6]});
    case Verb::AskBox:
      return asked.box({vector(0), vector(3)});
    case Verb::AskTouching:
      return asked.touching(oracle.palette()[question.number], question.pose);
    case Verb::AskWithin:
      return asked.within(oracle.palette()[question.number], question.pose, question.values[0]);
    case Verb::AskClosest:
      return asked.closest(oracle.palette()[question.number], question.pose);
    case Verb::AskCast:
      return asked.cast(oracle.palette()[question.number],
                        RigidMotion::between(question.pose, question.end),
                        {.clearance = question.values[0], .tolerance = 0x1p-12});
    default:
      throw std::logic_error("not a question");
  }
}

}  // namespace

void expect(bool is_true, const std::string& what) {
  if (!is_true) throw std::runtime_error(what);
}

/// Islands beside a search through all pairs that touch.
void check_islands(const World& world) {
  const auto joins = [&](BodyId id) {
    return world.kind(id) == BodyKind::Dynamic && world.role(id) == Role::Solid;
  };
  std::map<BodyId, std::vector<BodyId>> beside;
  for (const BodyId id : world.bodies()) {
    if (joins(id)) beside[id];
  }
  for (const auto& [a, b] : world.pairs()) {
    if (joins(a) && joins(b)) beside[a].push_back(b), beside[b].push_back(a);
  }
  std::vector<std::vector<BodyId>> wanted;
  std::set<BodyId> seen;
  for (const auto& [first, unused] : beside) {
    if (!seen.insert(first).second) continue;
    std::vector<BodyId> island{first};
    for (std::size_t i = 0; i < island.size(); ++i) {
      for (const BodyId next : beside[island[i]]) {
        if (seen.insert(next).second) island.push_back(next);
      }
    }
    std::sort(island.begin(), island.end());
    wanted.push_back(island);
  }
  expect(world.islands() == wanted, "islands() differs");
}

/// Once of all bodies, and once of those that a filter lets it meet.
std::size_t check_answer(const Operation& question, const World& world, const Oracle& oracle,
                         const std::map<BodyId, std::uint32_t>& names) {
  const BodyQuerySettings all, some{.filter = Filter{.category = 1, .mask = 3}};
  const Asked of_all(world, oracle, names, all), of_some(world, oracle, names, some);
  if (question.verb == Verb::AskClosestPair) return of_all.closest_pair();
  return check_one(question, of_all, oracle) + check_one(question, of_some, oracle);
}

}  // namespace graze::tests
