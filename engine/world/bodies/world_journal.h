#pragma once

// Who is told of all that is done to a world: what keeps a recording. Private to engine/.

#include <graze/bvh/box_pair.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/world/world.h>

#include <cstdint>
#include <memory>
#include <span>
#include <utility>

namespace graze {

struct Bodies;

/// All that a world is, for a journal that begins or begins anew: without changes that wait, unless
/// it has not been updated yet.
struct WorldContents {
  const WorldSettings& settings;
  const Bodies& all;
  std::span<const BoxPair> candidates;   ///< pairs of bodies, by index
  std::span<const std::uint8_t> states;  ///< of each of these, as a snapshot has them
  bool is_updated = true;                ///< no changes wait
};

/// What was done to one body; what it is now, Bodies says.
enum class BodyChange : std::uint8_t {
  Added,
  Removed,
  Shape,
  Filter,
  Kind,
  Role,
  Margin,
  Detection,
  UserData,
  Sleep,
  Wake
};

/// What was done to two.
enum class PairChange : std::uint8_t {
  Excluded,
  Included,
  Refused  ///< by the user's filter, or what else keeps the two from meeting, in an update
};

/// Is told of changes once they have taken place, in their order, by the thread that makes them. A
/// world without one pays a look at a pointer for each. None of this throws: who cannot keep what
/// it is told says so elsewhere.
class WorldJournal {
 public:
  virtual ~WorldJournal() = default;

  /// Whether it still wants to be told.
  virtual bool is_open() const noexcept = 0;
  virtual void note(BodyChange change, const Bodies& all, std::uint32_t body) noexcept = 0;
  virtual void note(PairChange change, std::uint32_t a, std::uint32_t b) noexcept = 0;
  virtual void note_moves(std::span<const BodyId> ids, std::span<const Pose> poses) noexcept = 0;
  virtual void note_motion(BodyId id, const RigidMotion& motion) noexcept = 0;
  virtual void note_pair_filter(bool is_set) noexcept = 0;
  /// What an update said. `follows_failure`: the one before it did not come to its end.
  virtual void note_update(const WorldUpdate& update, bool follows_failure) noexcept = 0;
  virtual void note_restored(const WorldContents& contents) noexcept = 0;
};

/// Where a world has its journal, if it has one.
class JournalPlace {
 public:
  bool is_taken() const { return journal_ != nullptr; }
  void take(std::shared_ptr<WorldJournal> journal) { journal_ = std::move(journal); }
  const std::shared_ptr<WorldJournal>& journal() const { return journal_; }

  void tell(BodyChange change, const Bodies& all, std::uint32_t index) const {
    if (journal_ != nullptr) [[unlikely]]
      journal_->note(change, all, index);
  }
  void tell(PairChange change, std::uint32_t a, std::uint32_t b) const {
    if (journal_ != nullptr) [[unlikely]]
      journal_->note(change, a, b);
  }
  void tell_moves(std::span<const BodyId> ids, std::span<const Pose> poses) const {
    if (journal_ != nullptr) [[unlikely]]
      journal_->note_moves(ids, poses);
  }

 private:
  std::shared_ptr<WorldJournal> journal_;
};

/// Access to a world's journal.
struct WorldJournalAccess {
  /// Throws InputError while another journal is open, or changes wait for an update: unless it will
  /// be the first one, and no body was removed or moved on a way that is swept.
  static void attach(World& world, std::shared_ptr<WorldJournal> journal);
  static WorldContents contents(const World& world);

 private:
  static bool has_only_come(const World::State& state);
};

}  // namespace graze
