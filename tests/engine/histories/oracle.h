#pragma once

// What a world should say, by asking every body about every other.

#include <graze/engine/world/manifold.h>

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "tests/engine/histories/history.h"

namespace graze::tests {

using NamePair = std::pair<std::uint32_t, std::uint32_t>;  // the smaller name first

/// Bodies by name. It knows no broad phase and no world; what the shapes said of a pair is kept
/// until either body is placed anew or takes another shape.
class Oracle {
 public:
  struct Being {
    std::uint32_t shape = 0;
    Pose pose = Pose::Identity();
    BodyKind kind = BodyKind::Dynamic;
    Role role = Role::Solid;
    Filter filter = {};
    bool is_awake = true;
    std::uint64_t version = 0;  // of shape and pose
  };

  explicit Oracle(Setting setting) : palette_(palette_of(setting)) {}

  bool has(std::uint32_t name) const { return beings_.contains(name); }
  const std::map<std::uint32_t, Being>& beings() const { return beings_; }
  const std::vector<Shape>& palette() const { return palette_; }
  const Shape& shape_of(std::uint32_t name) const { return palette_[beings_.at(name).shape]; }
  bool is_awake(std::uint32_t name) const;
  bool are_alike(std::uint32_t a, std::uint32_t b) const;  // of one shape, in one pose

  /// False if the operation names a body that is not there: then nothing happens.
  bool concerns_nobody(const Operation& operation) const;
  void change(const Operation& operation);

  /// Pairs that touch now, ascending. Where something changed but nobody is awake those of `before`
  /// stand, unless their boxes or a filter part them.
  std::vector<NamePair> touching(const std::vector<NamePair>& before);
  bool are_solid(const NamePair& pair) const;
  Manifold contacts(const NamePair& pair) const;

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
    bool touches;
  };

  bool has_changed(std::uint32_t name) const;
  bool is_looked_at(const NamePair& pair) const;
  bool do_boxes_overlap(const Being& s, const Being& t) const;
  bool meet(std::uint32_t a, const Being& s, std::uint32_t b, const Being& t) const;
  bool touch(std::uint32_t a, const Being& s, std::uint32_t b, const Being& t);

  std::vector<Shape> palette_;
  std::map<std::uint32_t, Being> beings_;
  std::set<NamePair> excluded_;
  std::uint32_t divisor_ = 0;
  std::set<std::uint32_t> changed_, excluded_anew_;
  bool has_lost_ = false;
  std::uint64_t version_ = 0;
  std::map<NamePair, Answer> answers_;
};

NamePair ordered(std::uint32_t a, std::uint32_t b);

}  // namespace graze::tests
