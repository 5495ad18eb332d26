#pragma once

// What a world should say, by asking every body about every other.

#include <graze/engine/world/manifold.h>

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "tests/engine/histories/history.h"
#include "tests/engine/histories/part_table.h"

namespace graze::tests {

using NamePair = std::pair<std::uint32_t, std::uint32_t>;  // the smaller name first

/// Contacts of two parts, or of bodies that have none.
struct PartContacts {
  std::uint32_t part_a = 0, part_b = 0;
  Manifold manifold;
};

/// Bodies by name. It knows no broad phase and no world; what the shapes said of a pair is kept
/// until either body is placed anew or takes another shape.
class Oracle {
 public:
  struct Being {
    std::uint32_t shape = 0;  // or a plan beyond the palette
    std::optional<PartTable> parts = {};
    Pose pose = Pose::Identity();
    BodyKind kind = BodyKind::Dynamic;
    Role role = Role::Solid;
    Filter filter = {};
    bool is_awake = true;
    double margin = 0;
    Detection detection = Detection::Discrete;
    std::optional<Pose> before = {};  // at the last update, if it moved since and that is noted
    std::uint64_t version = 0;        // of all of this
    std::vector<Piece> pieces = {};

    /// What it is made of where its body is in a pose.
    std::vector<Piece> pieces_at(const Pose& at) const;
  };

  explicit Oracle(Setting setting) : palette_(palette_of(setting)), plans_(plans_of(setting)) {}

  bool has(std::uint32_t name) const { return beings_.contains(name); }
  const std::map<std::uint32_t, Being>& beings() const { return beings_; }
  const std::vector<Shape>& palette() const { return palette_; }
  /// A body's parts, or itself, in the world.
  const std::vector<Piece>& pieces_of(std::uint32_t name) const { return beings_.at(name).pieces; }
  PlacedShapeView placed(const Piece& piece) const { return {palette_[piece.shape], piece.pose}; }
  /// That of the world, which holds those of the pieces.
  Aabb box_of(std::uint32_t name) const;
  bool is_awake(std::uint32_t name) const;
  /// Of one shape, in one pose.
  bool are_alike(const NamePair& pair, std::uint32_t part_a, std::uint32_t part_b) const;

  /// False if the operation names a body that is not there: then nothing happens.
  bool concerns_nobody(const Operation& operation) const;
  void change(const Operation& operation);

  /// Pairs that touch now, and those with a margin that are within it, ascending. Where something
  /// changed but nobody is awake those of `before` stand, unless their boxes with the margins
  /// around them, or a filter, part them.
  struct Lists {
    std::vector<NamePair> touching, near;
  };
  Lists lists(const Lists& before);
  bool are_solid(const NamePair& pair) const;
  /// Those of parts that touch or are near, in the order of their numbers; of bodies without any
  /// one entry.
  std::vector<PartContacts> contacts(const NamePair& pair) const;
  /// Whether kinds, filters and exclusions let two bodies meet, and those of parts two of these.
  bool may_meet(const NamePair& pair) const;
  bool may_meet(const NamePair& pair, const Piece& s, const Piece& t) const;

  /// What an update has to list in `moved`: bodies that moved, came, woke or changed what they are;
  /// and what it may list besides: those whose exclusions changed. Not where both sleep.
  bool must_be_listed(const NamePair& pair) const;
  bool may_be_listed(const NamePair& pair) const;

  /// True if a change waits for an update.
  bool is_unsettled() const { return !changed_.empty() || !excluded_anew_.empty() || has_lost_; }
  void settle();

 private:
  struct Answer {
    std::uint64_t version_a, version_b;
    bool touches, is_near;
  };

  void remove(std::uint32_t name);
  bool has_changed(std::uint32_t name) const;
  bool is_looked_at(const NamePair& pair) const;
  double margin(const NamePair& pair) const;
  const Answer& answer(const NamePair& pair);
  Answer answer_of_pieces(const NamePair& pair) const;
  bool do_boxes_meet(const NamePair& pair) const;
  bool is_anyone_swept() const;
  void set_detection(Being& being, Detection detection);
  void take_shape(Being& being, std::uint32_t number) const;

  std::vector<Shape> palette_;
  std::vector<PartsPlan> plans_;
  std::map<std::uint32_t, Being> beings_;
  std::set<NamePair> excluded_;
  std::uint32_t divisor_ = 0;
  std::set<std::uint32_t> changed_, excluded_anew_;
  bool has_lost_ = false;
  std::uint64_t version_ = 0;
  std::map<NamePair, Answer> answers_;
};

NamePair ordered(std::uint32_t a, std::uint32_t b);
/// A half-space or a plane.
bool is_endless(const Shape& shape);

}  // namespace graze::tests
