#pragma once

// What a recording of a world holds, as values. format.md has its bytes.

#include <graze/bvh/error.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/world/body.h>
#include <graze/engine/world/world.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace graze {

/// A recording that cannot be read, or cannot be repeated: what() reads `file: byte N: why`, or
/// `file: why`.
class RecordingError : public Error {
 public:
  using Error::Error;
};

/// Of which pairs the contacts are kept that an update listed.
enum class RecordedContacts : std::uint8_t {
  None,   ///< of none
  Begun,  ///< of those that began to touch or came within their margin in that update
  All     ///< of all that the update listed
};

/// What a recording says of itself, at its beginning.
struct RecordingHead {
  std::string engine_version;      ///< of graze that wrote it: "0.9.0"
  std::string note;                ///< what it shows; may be empty
  double seconds_per_update = 0;   ///< 0: nobody said
  RecordedContacts contacts = {};  ///< which are kept
  bool has_work = false;           ///< whether each update's WorldWork is kept
  WorldSettings world = {};        ///< of the world that was recorded
};

/// A body came.
struct BodyAdded {
  BodyId id;                   ///< that World::add() gave out
  std::uint32_t shape = 0;     ///< a number for RecordingReader::shape()
  Pose pose;                   ///< where it was put
  BodySettings settings = {};  ///< what it was added with
};
/// It was taken out.
struct BodyRemoved {
  BodyId id;  ///< of the body
};
/// It was moved.
struct BodyMoved {
  BodyId id;  ///< of the body
  Pose pose;  ///< where to
};
/// It was taken along a motion, and is swept.
struct BodyTaken {
  BodyId id;           ///< of the body
  RigidMotion motion;  ///< from where to where it goes
};
/// It has another shape.
struct BodyReshaped {
  BodyId id;                ///< of the body
  std::uint32_t shape = 0;  ///< a number for RecordingReader::shape()
};
/// One of its settings was set.
struct BodySet {
  /// Which of them.
  enum class What : std::uint8_t {
    Filter,     ///< by World::set_filter()
    Kind,       ///< by World::set_kind()
    Role,       ///< by World::set_role()
    Margin,     ///< by World::set_margin()
    Detection,  ///< by World::set_detection()
    UserData    ///< by World::set_user_data()
  };
  BodyId id;                   ///< of the body
  What what = What::Filter;    ///< which one
  BodySettings settings = {};  ///< only that one is said here
};
/// It was put to sleep, or woken.
struct BodySlept {
  BodyId id;              ///< of the body
  bool is_awake = false;  ///< whether it was woken
};
/// Two bodies were told never to meet, or that they may again.
struct PairExcluded {
  BodyId a;                 ///< one of them
  BodyId b;                 ///< the other
  bool is_excluded = true;  ///< false: they may meet again
};
/// A filter of the user's own was set, or taken away. What it said stands in RecordedStep::refused.
struct PairFilterSet {
  bool is_set = true;  ///< false: there is none any more
};
/// A body was given a name, by WorldRecorder::name().
struct BodyNamed {
  BodyId id;         ///< of the body
  std::string name;  ///< as it was given
};

/// A body of a world as it was.
struct RecordedBody {
  BodyId id;                   ///< in the recorded world
  std::uint32_t shape = 0;     ///< a number for RecordingReader::shape()
  Pose pose;                   ///< where it is
  BodySettings settings = {};  ///< as they are now
  bool is_awake = true;        ///< see World::sleep()
};

/// All that a world was at a moment: where a recording begins, or after World::restore().
struct RecordedState {
  std::vector<RecordedBody> bodies = {};  ///< ascending
  std::vector<BodyPair> touching = {};    ///< ascending
  WorldSnapshot snapshot;                 ///< the same for World::restore()
  /// Nothing had been known of any pair: then what the recorded world did from there on, WorldWork,
  /// is what a restored one does.
  bool is_fresh = true;
};

/// The world was taken back to what it had been.
struct WorldRestored {
  std::shared_ptr<const RecordedState> state;  ///< not nullptr
};

/// Whatever was done to a world between two updates.
using RecordedChange =
    std::variant<BodyAdded, BodyRemoved, BodyMoved, BodyTaken, BodyReshaped, BodySet, BodySlept,
                 PairExcluded, PairFilterSet, BodyNamed, WorldRestored>;

/// What an update said, as far as it is kept.
struct RecordedAnswers {
  std::vector<BodyPair> begun = {};        ///< as WorldUpdate has them, and so are the next three
  std::vector<BodyPair> ended = {};        ///< likewise
  std::vector<BodyPair> begun_near = {};   ///< likewise
  std::vector<BodyPair> ended_near = {};   ///< likewise
  std::uint64_t moved = 0;                 ///< how many pairs WorldUpdate::moved had
  std::uint64_t all_contacts = 0;          ///< how many manifolds WorldUpdate::contacts had
  std::vector<BodyContact> contacts = {};  ///< of these, those that are kept
  std::vector<BodyFirstContact> first_contacts = {};  ///< all
  std::optional<WorldWork> work = {};                 ///< if it is kept

  bool operator==(const RecordedAnswers&) const = default;
};

/// What of an update a recording keeps. O(what is kept).
RecordedAnswers answers_of(const WorldUpdate& update, RecordedContacts contacts, bool has_work);

/// One update, and what led to it.
struct RecordedStep {
  std::size_t number = 0;                    ///< counted from 0
  std::vector<RecordedChange> changes = {};  ///< since the last update, in their order
  /// Pairs that the user's filter refused in this update, or that something else keeps apart while
  /// there is such a filter; ascending.
  std::vector<BodyPair> refused = {};
  RecordedAnswers answers = {};  ///< what it said
  /// The update before it was cut short by what a filter threw: this one looked at every body, and
  /// its `moved`, contacts and work are those of no repetition.
  bool follows_failure = false;
};

}  // namespace graze
