#pragma once

// Two worlds of one scene: in the one some bodies are compounds or height fields, in the other each
// part is a body and each field a mesh.

#include <graze/engine/world/compound.h>
#include <graze/engine/world/world.h>

#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "tests/shapes/random_source.h"

namespace graze::tests {

/// A part of a body, by the body's number and its own; a body that is no compound is its part 0.
using Named = std::pair<std::uint32_t, std::uint32_t>;

/// When something comes to a part of a body, and which.
using PartContact = std::pair<RigidContact, std::uint32_t>;

struct NamedContact {
  Named a, b;
  Manifold manifold;
  bool operator==(const NamedContact&) const = default;
};

struct NamedFirstContact {
  Named a, b;
  RigidContact contact;
  bool is_at_start;
  Eigen::Vector3d normal, point;
  bool operator==(const NamedFirstContact&) const = default;
};

/// Both worlds: bodies by numbers, which are their indices in the one of compounds.
class Twins {
 public:
  explicit Twins(const WorldSettings& settings);
  Twins(const Twins&) = delete;  // a filter refers to it
  Twins& operator=(const Twins&) = delete;

  std::uint32_t add(const Compound& compound, const Pose& pose, const BodySettings& settings = {});
  std::uint32_t add(const Shape& shape, const Pose& pose, const BodySettings& settings = {});
  /// First contacts of a compound that moved so are not compared: its parts go another way.
  void move(std::uint32_t body, const Pose& pose);
  /// Whoever is swept goes there in both worlds.
  void move(std::uint32_t body, const RigidMotion& motion);
  /// For a while the world of compounds goes on alone: the parts come after with catch_up().
  void move_alone(std::uint32_t body, const Pose& pose);
  void update_alone() { whole_.update(); }
  void catch_up();
  /// Replaces a compound: parts in the other world go, come and change.
  void set_compound(std::uint32_t body, const Compound& compound);
  std::size_t size() const { return bodies_.size(); }
  const Pose& pose(std::uint32_t body) const { return bodies_[body].pose; }
  const Compound& compound(std::uint32_t body) const { return bodies_[body].compound; }
  bool is_compound(std::uint32_t body) const { return bodies_[body].compound.size() != 0; }

  /// Updates both, and expects that they say the same. Returns how many contacts there were.
  std::size_t update();
  /// The same of first contacts alone.
  std::size_t update_ways();
  /// What queries say, expected to be the same in both. Returns how many answers there were.
  std::size_t ask(const Shape& shape, const Pose& pose, double clearance);
  std::size_t cast_ray(const Ray& ray);
  std::size_t cast(const Shape& shape, const RigidMotion& motion);
  /// Likewise of bodies far from the origin, where times may differ within tolerances.
  std::size_t cast_far(const Shape& shape, const RigidMotion& motion);

  World& whole() { return whole_; }

 private:
  struct Body {
    BodyId id;
    Compound compound;  ///< empty of what is none
    Pose pose;
    BodySettings settings;
    std::vector<std::pair<std::uint32_t, BodyId>> parts;  ///< in the other world
    bool is_way_other = false;  ///< whether parts went another way to where they are
    bool is_ahead = false;      ///< of its parts, where they are not moved along
  };

  BodyId add_part(std::uint32_t body, std::uint32_t part);
  void move_parts(std::uint32_t body);
  Named name(BodyId of_part) const { return names_[of_part.index]; }
  bool is_field(std::uint32_t body) const;
  BodyId part_id(Named named) const;
  bool is_same(const BodyDistance& found, const ShapeDistance& wanted, const Shape& asked) const;
  std::map<std::uint32_t, PartContact> casts_at_parts(const Shape& shape,
                                                      const RigidMotion& motion) const;
  std::size_t expect_same_ways(const WorldUpdate& of_whole, const WorldUpdate& of_parts);
  std::vector<NamedContact> contacts_of_whole(std::span<const BodyContact> contacts) const;
  std::vector<NamedContact> contacts_of_parts(std::span<const BodyContact> contacts) const;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_of_parts() const;

  World whole_, parts_;
  std::vector<Body> bodies_;
  std::vector<Named> names_;  ///< by index in the world of parts
};

/// Shapes of all kinds but half-spaces, in random poses of a ball of that radius.
Compound random_compound(RandomSource& source, std::uint32_t parts, double radius);

}  // namespace graze::tests
