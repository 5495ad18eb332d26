#pragma once

#include <graze/engine/world/body.h>
#include <graze/engine/world/placed_shape.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace graze {

/// What a part of a compound is to others. A world reads the filter alone.
struct PartSettings {
  /// Whom the part meets among those that its body may meet; if there is none, it meets all of
  /// them. Where two parts stand against each other, or a part and a body that is no compound, each
  /// has its own filter, or else its body's.
  std::optional<Filter> filter = {};
  std::uint64_t user_data = 0;  ///< a number that nobody reads
  std::uint32_t material = 0;   ///< likewise: what it is made of, say
};

/// Several shapes with poses, to be one body: share() makes a BodyShape of it. A value: parts can
/// be added, replaced and removed one by one, and what was shared before stays as it was; a body
/// gets the new one by World::set_shape(). Parts may overlap, which is nobody's contact, and meshes
/// are parts like any other shape, as surfaces. Parts are known by small numbers; one that is free
/// is used again, that which was freed last first.
class Compound {
 public:
  /// A part in the compound's own frame. Throws InputError for a half-space or a plane, which are
  /// bodies of their own, and PoseError as bounding_aabb() does. O(1), O(vertices) for a hull.
  std::uint32_t add(const PlacedShapeView& part, const PartSettings& settings = {});
  /// Gives a part another shape and pose; its settings stay. Throws likewise. This, and all that
  /// take the number of a part, throw StaleIdError where there is none.
  void replace(std::uint32_t part, const PlacedShapeView& by);
  void set_settings(std::uint32_t part, const PartSettings& settings);
  void remove(std::uint32_t part);

  /// Whether there is a part of this number.
  bool contains(std::uint32_t part) const;
  /// How many parts there are.
  std::size_t size() const { return parts_.size() - free_.size(); }
  /// The numbers of the parts, ascending.
  std::vector<std::uint32_t> parts() const;
  /// The part in the compound's frame.
  const PlacedShape& part(std::uint32_t part) const;
  /// The settings that add() or set_settings() gave the part last.
  const PartSettings& settings(std::uint32_t part) const;

 private:
  friend class CompoundBody;
  struct Part {
    PlacedShape placed;
    PartSettings settings;
  };
  const Part& at(std::uint32_t part, const char* what) const;

  std::vector<std::optional<Part>> parts_;  ///< by number
  std::vector<std::uint32_t> free_;
};

/// The compound as a world asks it, for World::add() and World::set_shape(): one for many bodies.
/// What it meets, where and when is what its parts meet as bodies of their own, each in the pose
/// placed_part(body, part); times of casts differ by less than their tolerance, which for a body of
/// its own grows with the distance of the world's origin. Moving such a body costs nothing for each
/// part; an answer costs the parts near the other, which are looked up in boxes: O(log n + near).
/// Throws InputError for one without parts, PoseError for one that reaches beyond kLargestLength.
/// O(n log n); it takes up to 512 bytes, and as much for each part, with 60 more from when the
/// nearest of many is asked for.
///
/// A body's pose is refused (PoseError) where that of a part is. Of `gap()` such a shape knows
/// nothing: pairs in which something moved are asked again.
std::shared_ptr<const BodyShape> share(const Compound& compound);

/// The compound that a shape stands for, as it was shared, or nullptr: to look up what a contact or
/// a ray says of parts.
const Compound* compound_of(const BodyShape& shape);

/// The pose of a part whose body is in `body`: for each entry ((R_i0 x + R_i1 y) + R_i2 z), and for
/// the translation + t_i, each operation rounded. Nothing is checked.
Pose placed_part(const Pose& body, const Pose& part);

}  // namespace graze
