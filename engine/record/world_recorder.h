#pragma once

#include <graze/engine/record/recording.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace graze {

/// Says when an update's block is handed to the system.
enum class RecordedWriting : std::uint8_t {
  Behind,  ///< up to four updates later, by a thread of the recorder's own: this costs the world
           ///< least
  AtOnce   ///< before update() returns, for programs that may crash
};

/// Says what a WorldRecorder keeps beside inputs and pairs, and how it writes.
struct WorldRecorderSettings {
  RecordedContacts contacts = RecordedContacts::Begun;  ///< the pairs whose contacts are kept
  bool has_work = true;           ///< true to keep each update's WorldWork, some 40 bytes
  double seconds_per_update = 0;  ///< seconds, for those who look at it; finite and not negative; 0
                                  ///< if unknown
  std::string note = {};          ///< a note for people on what it shows
  RecordedWriting writing = RecordedWriting::Behind;  ///< says when each block is handed on
};

/// Writes down what is done to a world and what its updates say: while the recorder lives
/// everything that changes the world is noted, and each update() ends with a block in the file.
/// Poses, filters and shapes are kept to the last bit, so that the run can be repeated
/// (RecordingReplay). A world that nobody records pays one look at a pointer for each change.
///
/// Each update is handed to the system soon after update() returned, by a thread that the recorder
/// starts, so that the world hardly waits; with RecordedWriting::AtOnce before update() returns. So
/// a program that ends in whatever way leaves a file that can be read up to one of its last
/// updates, or with AtOnce up to its last one, and the file can be read while it is written.
/// Changes after the last update are not kept.
///
/// A shape is written once, however many bodies have it: those with equal numbers are one. Shapes
/// of a user's own cannot be kept.
///
/// What goes wrong while the world runs - a full disk, a shape of a user's own - does not disturb
/// the world: the recording ends there, has_failed() says so, and finish() throws it. It is for the
/// thread that changes the world.
class WorldRecorder {
 public:
  /// Begins a recording with all that the world is, which may be empty, in a file that takes the
  /// place of what was there. Throws InputError for invalid settings, while the world is being
  /// recorded already, for a body whose shape is a user's own, and while changes wait for an
  /// update, unless that will be the first one; and an Error that names the file if it cannot be
  /// written. Takes O(bodies and pairs of the world).
  WorldRecorder(World& world, const std::filesystem::path& file,
                const WorldRecorderSettings& settings = {});
  /// Begins a recording whose bytes `sink` takes: it is called once now, and once for each update,
  /// from the recorder's own thread unless they are written AtOnce, and never twice at a time. What
  /// the sink throws ends the recording, as a full disk does.
  WorldRecorder(World& world, std::function<void(std::string_view)> sink,
                const WorldRecorderSettings& settings = {});
  /// Finishes as finish() does, but says nothing of what went wrong.
  ~WorldRecorder();
  WorldRecorder(WorldRecorder&& other) noexcept;  ///< a recorder that was moved from is finished
  WorldRecorder& operator=(WorldRecorder&& other) noexcept;  ///< a recorder that was moved from is
                                                             ///< finished

  /// Gives a body a name for those who look at the recording. Throws StaleIdError for one that is
  /// not there.
  void name(BodyId id, std::string_view name);

  /// Returns how many updates are in the recording. This and the next two functions wait until all
  /// updates that have taken place are written; the sink, which may ask, too, is told what is
  /// written.
  std::size_t updates() const;
  /// Returns how many bytes it has.
  std::uint64_t bytes() const;
  /// True if it ended before its time: finish() throws why.
  bool has_failed() const noexcept;

  /// Writes the end, by which a reader knows that nothing is missing. From then on nothing is noted
  /// any more, and another recorder may begin. Throws what has gone wrong since the beginning; a
  /// second call does nothing.
  void finish();

 private:
  class Journal;
  std::shared_ptr<Journal> journal_;
};

}  // namespace graze
