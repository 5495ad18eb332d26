#pragma once

// The interface of a journal, which is told of all changes of a world and keeps a recording.
// Private to engine/.

#include <graze/bvh/box_pair.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/world/world.h>

#include <cstdint>
#include <memory>
#include <span>
#include <utility>

namespace graze {

struct Bodies;

/// The whole state of a world, for a journal that begins or begins anew. No changes wait for an
/// update, unless the world has not been updated yet.
struct WorldContents {
  const WorldSettings& settings;
  const Bodies& all;
  std::span<const BoxPair> candidates;   ///< pairs of bodies, by index
  std::span<const std::uint8_t> states;  ///< the state of each candidate, as in a snapshot
  bool is_updated = true;                ///< true if no changes wait for an update
};

/// The kinds of changes of one body. Bodies has its state after the change.
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

/// The kinds of changes of a pair of bodies.
enum class PairChange : std::uint8_t {
  Excluded,
  Included,
  Refused  ///< in an update the user's filter, or something else, kept the two from meeting
};

/// A journal is told of changes after they have taken place, in their order, by the thread that
/// makes them. A world without a journal tests one pointer for each change. None of these functions
/// throws: a journal that cannot keep what it is told reports that elsewhere.
class WorldJournal {
 public:
  virtual ~WorldJournal() = default;

  /// True if the journal still wants to be told.
  virtual bool is_open() const noexcept = 0;
  virtual void note(BodyChange change, const Bodies& all, std::uint32_t body) noexcept = 0;
  virtual void note(PairChange change, std::uint32_t a, std::uint32_t b) noexcept = 0;
  virtual void note_moves(std::span<const BodyId> ids, std::span<const Pose> poses) noexcept = 0;
  virtual void note_motion(BodyId id, const RigidMotion& motion) noexcept = 0;
  virtual void note_pair_filter(bool is_set) noexcept = 0;
  /// Notes the results of an update. `follows_failure` is true if the update before it was not
  /// completed.
  virtual void note_update(const WorldUpdate& update, bool follows_failure) noexcept = 0;
  virtual void note_restored(const WorldContents& contents) noexcept = 0;
};

/// The place for the journal of a world, if it has one.
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
  /// Attaches a journal. Throws InputError while another journal is open, or while changes wait for
  /// an update, unless that will be the first update and no body was removed or moved on a way that
  /// is swept.
  static void attach(World& world, std::shared_ptr<WorldJournal> journal);
  static WorldContents contents(const World& world);

 private:
  static bool has_only_come(const World::State& state);
};

}  // namespace graze
