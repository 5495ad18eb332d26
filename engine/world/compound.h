#pragma once

#include <graze/engine/world/body.h>
#include <graze/engine/world/placed_shape.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace graze {

/// Settings of a part of a compound. A world reads only the filter.
struct PartSettings {
  /// Says which of the bodies that its body may meet the part meets; a part without a filter meets
  /// all of them. Where two parts are compared, or a part and a body that is no compound, each has
  /// its own filter, or else its body's.
  std::optional<Filter> filter = {};
  std::uint64_t user_data = 0;  ///< a number that nobody reads
  std::uint32_t material = 0;   ///< a number that nobody reads, such as what the part is made of

  bool operator==(const PartSettings&) const = default;
};

/// Several shapes with poses that form one body: share() makes a BodyShape of them. A compound is a
/// value: parts can be added, replaced and removed one by one, and what was shared before stays as
/// it was; World::set_shape() gives a body the new compound. Parts may overlap, which makes no
/// contact; a mesh may be a part like any other shape, and counts as a surface. Parts are known by
/// small numbers; a freed number is used again, the one freed last first.
class Compound {
 public:
  /// Adds a part in the compound's own frame and returns its number. Throws InputError for a
  /// half-space or a plane, which must be bodies of their own, and PoseError as bounding_aabb()
  /// does. It costs O(1), and O(vertices) for a hull.
  std::uint32_t add(const PlacedShapeView& part, const PartSettings& settings = {});
  /// Gives a part another shape and pose; its settings stay. Throws as add() does. This function,
  /// and all others that take the number of a part, throw StaleIdError if there is no such part.
  void replace(std::uint32_t part, const PlacedShapeView& by);
  void set_settings(std::uint32_t part, const PartSettings& settings);
  void remove(std::uint32_t part);

  /// True if there is a part of this number.
  bool contains(std::uint32_t part) const;
  /// Returns the number of parts.
  std::size_t size() const { return parts_.size() - free_.size(); }
  /// Returns the numbers of the parts, ascending.
  std::vector<std::uint32_t> parts() const;
  /// Returns the part in the compound's frame.
  const PlacedShape& part(std::uint32_t part) const;
  /// Returns the settings that add() or set_settings() gave the part last.
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

/// Makes a BodyShape of a compound, for World::add() and World::set_shape(); many bodies may share
/// it. It meets what its parts would meet as bodies of their own, at the same places and times,
/// each part in the pose placed_part(body, part). Only times of casts differ, by less than their
/// tolerance, which for a body of its own grows with the distance from the world's origin. Moving
/// such a body costs nothing for its parts; an answer looks up the parts near the other body in
/// boxes, which costs O(log n + near). Throws InputError for a compound without parts, and
/// PoseError for one that reaches beyond kLargestLength. It costs O(n log n); the shape takes up to
/// 512 bytes, and as much for each part, with 60 more once the nearest of many parts has been asked
/// for.
///
/// A body's pose is refused (PoseError) where that of a part is. `gap()` of such a shape is 0, so
/// that pairs in which something moved are tested again.
std::shared_ptr<const BodyShape> share(const Compound& compound);

/// Returns the compound that a shape stands for, as it was shared, or nullptr. With it the numbers
/// of parts in contacts and ray hits can be looked up.
const Compound* compound_of(const BodyShape& shape);

/// Returns the pose of a part whose body is in the pose `body`: each entry is ((R_i0 x + R_i1 y) +
/// R_i2 z), to which the translation adds t_i, and each operation is rounded. Nothing is checked.
Pose placed_part(const Pose& body, const Pose& part);

}  // namespace graze
