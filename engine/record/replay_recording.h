#pragma once

#include <graze/engine/record/read_recording.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace graze {

/// Says where two runs part first.
struct RecordingDifference {
  std::size_t update = 0;             ///< counted from 0
  std::string what;                   ///< "begun", "contacts", "work", ...
  std::optional<BodyPair> pair = {};  ///< the pair that differs, where the difference is about one
  std::string first;                  ///< a few words for what the first run said
  std::string second;                 ///< a few words for what the second run said

  bool operator==(const RecordingDifference&) const = default;
};

/// Returns the first difference in the answers to one update, in the order of the lists of
/// RecordedAnswers and of the pairs in them, and nothing if they are equal. Counters of work are
/// compared if both have them.
std::optional<RecordingDifference> first_difference(std::size_t update,
                                                    const RecordedAnswers& first,
                                                    const RecordedAnswers& second);

/// Returns the first difference in what was done before an update: bodies that came and went,
/// poses, settings. Shapes are compared by their numbers, which are equal for equal histories.
std::optional<RecordingDifference> first_difference(std::size_t update,
                                                    const std::vector<RecordedChange>& first,
                                                    const std::vector<RecordedChange>& second);

/// Says how a recording is repeated.
struct RecordingReplaySettings {
  int threads = 1;        ///< as WorldSettings has it; no answer depends on it
  bool has_work = false;  ///< true to compare WorldWork, too: that of other versions differs
  bool skips = true;      ///< false for a world that skips nothing (WorldSettings), which is slow
};

/// Does to a world of its own what was done to the recorded one, update by update, and says where
/// their answers part.
class RecordingReplay {
 public:
  /// Takes over the reader, of which nothing has been read but its start. Throws what the world
  /// throws that is made.
  explicit RecordingReplay(RecordingReader reader, const RecordingReplaySettings& settings = {});
  ~RecordingReplay();
  RecordingReplay(RecordingReplay&& other) noexcept;  ///< what was moved from can be destroyed or
                                                      ///< assigned to, as with its reader
  RecordingReplay& operator=(RecordingReplay&& other) noexcept;  ///< what was moved from can be
                                                                 ///< destroyed or assigned to, as
                                                                 ///< with its reader

  /// Repeats the next update. False at the end of the recording. Throws as the reader and the world
  /// do; RecordingError, too, where the world gives a body another id than it had.
  bool advance();

  /// Returns the update that was repeated last, as it was recorded.
  const RecordedStep& step() const;
  /// Returns what differed in it: `first` is what was recorded, `second` what the world says now.
  const std::optional<RecordingDifference>& difference() const;
  /// Returns all that the world says to it now. Valid until the next call of advance().
  const WorldUpdate& update() const;
  /// Returns the world after it.
  const World& world() const;
  /// Returns the reader, to look up shapes, and how the recording ended.
  const RecordingReader& reader() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace graze
