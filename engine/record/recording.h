#pragma once

// This file holds what a recording of a world holds, as values. format.md has its bytes.

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

/// Thrown for a recording that cannot be read, or cannot be repeated: what() reads `file: byte
/// N: why`, or `file: why`.
class RecordingError : public Error {
 public:
  using Error::Error;
};

/// Says of which pairs an update's contacts are kept.
enum class RecordedContacts : std::uint8_t {
  None,   ///< of no pairs
  Begun,  ///< of pairs that began to touch or came within their margin in that update
  All     ///< of all pairs that the update listed
};

/// Holds what a recording says of itself, at its beginning.
struct RecordingHead {
  std::string engine_version;      ///< the version of graze that wrote it: "0.9.0"
  std::string note;                ///< what the recording shows; may be empty
  double seconds_per_update = 0;   ///< 0 if nobody said it
  RecordedContacts contacts = {};  ///< which contacts are kept
  bool has_work = false;           ///< true if each update's WorldWork is kept
  WorldSettings world = {};        ///< the settings of the world that was recorded
};

/// A body came.
struct BodyAdded {
  BodyId id;                   ///< the id that World::add() gave out
  std::uint32_t shape = 0;     ///< a number for RecordingReader::shape()
  Pose pose;                   ///< where it was put
  BodySettings settings = {};  ///< the settings that it was added with
};
/// A body was taken out.
struct BodyRemoved {
  BodyId id;  ///< the body
};
/// A body was moved.
struct BodyMoved {
  BodyId id;  ///< the body
  Pose pose;  ///< the pose that it was moved to
};
/// A body was taken along a motion, and is swept.
struct BodyTaken {
  BodyId id;           ///< the body
  RigidMotion motion;  ///< the motion from where it was to where it goes
};
/// A body was given another shape.
struct BodyReshaped {
  BodyId id;                ///< the body
  std::uint32_t shape = 0;  ///< a number for RecordingReader::shape()
};
/// One of a body's settings was set.
struct BodySet {
  /// Names the setting.
  enum class What : std::uint8_t {
    Filter,     ///< by World::set_filter()
    Kind,       ///< by World::set_kind()
    Role,       ///< by World::set_role()
    Margin,     ///< by World::set_margin()
    Detection,  ///< by World::set_detection()
    UserData    ///< by World::set_user_data()
  };
  BodyId id;                   ///< the body
  What what = What::Filter;    ///< the setting that was set
  BodySettings settings = {};  ///< holds that setting alone
};
/// A body was put to sleep, or woken.
struct BodySlept {
  BodyId id;              ///< the body
  bool is_awake = false;  ///< true if it was woken
};
/// Two bodies were told never to meet, or that they may again.
struct PairExcluded {
  BodyId a;                 ///< one of the two
  BodyId b;                 ///< the other one
  bool is_excluded = true;  ///< false if they may meet again
};
/// A filter of the user's own was set, or taken away. What it said stands in RecordedStep::refused.
struct PairFilterSet {
  bool is_set = true;  ///< false if there is no filter any more
};
/// A body was given a name, by WorldRecorder::name().
struct BodyNamed {
  BodyId id;         ///< the body
  std::string name;  ///< the name as it was given
};

/// A body of a world as it was.
struct RecordedBody {
  BodyId id;                   ///< its id in the recorded world
  std::uint32_t shape = 0;     ///< a number for RecordingReader::shape()
  Pose pose;                   ///< its pose
  BodySettings settings = {};  ///< its settings as they are now
  bool is_awake = true;        ///< true if it is awake: see World::sleep()
};

/// Holds all that a world was at a moment: where a recording begins, or after World::restore().
struct RecordedState {
  std::vector<RecordedBody> bodies = {};  ///< the bodies, ascending
  std::vector<BodyPair> touching = {};    ///< the pairs that touch, ascending
  WorldSnapshot snapshot;                 ///< the state as World::restore() takes it
  /// True if nothing had been known of any pair: then what the recorded world did from there on,
  /// WorldWork, is what a restored one does.
  bool is_fresh = true;
};

/// The world was taken back to what it had been.
struct WorldRestored {
  std::shared_ptr<const RecordedState> state;  ///< not nullptr
};

/// Holds whatever was done to a world between two updates.
using RecordedChange =
    std::variant<BodyAdded, BodyRemoved, BodyMoved, BodyTaken, BodyReshaped, BodySet, BodySlept,
                 PairExcluded, PairFilterSet, BodyNamed, WorldRestored>;

/// Holds what an update said, as far as it is kept.
struct RecordedAnswers {
  std::vector<BodyPair> begun = {};        ///< as WorldUpdate has them
  std::vector<BodyPair> ended = {};        ///< as WorldUpdate has them
  std::vector<BodyPair> begun_near = {};   ///< as WorldUpdate has them
  std::vector<BodyPair> ended_near = {};   ///< as WorldUpdate has them
  std::uint64_t moved = 0;                 ///< the number of pairs in WorldUpdate::moved
  std::uint64_t all_contacts = 0;          ///< the number of manifolds in WorldUpdate::contacts
  std::vector<BodyContact> contacts = {};  ///< those of them that are kept
  std::vector<BodyFirstContact> first_contacts = {};  ///< all first contacts
  std::optional<WorldWork> work = {};                 ///< the update's work, if it is kept

  bool operator==(const RecordedAnswers&) const = default;
};

/// Returns what a recording keeps of an update. Takes O(what is kept).
RecordedAnswers answers_of(const WorldUpdate& update, RecordedContacts contacts, bool has_work);

/// Holds one update, and what led to it.
struct RecordedStep {
  std::size_t number = 0;                    ///< its number, counted from 0
  std::vector<RecordedChange> changes = {};  ///< the changes since the last update, in their order
  /// The pairs that the user's filter refused in this update, or that something else keeps apart
  /// while there is such a filter; ascending.
  std::vector<BodyPair> refused = {};
  RecordedAnswers answers = {};  ///< what the update said
  /// True if the update before it was cut short by what a filter threw: then this one looked at
  /// every body, and no repetition has its `moved`, contacts and work.
  bool follows_failure = false;
};

}  // namespace graze
