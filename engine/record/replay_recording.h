#pragma once

#include <graze/engine/record/read_recording.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace graze {

/// Where two runs part first.
struct RecordingDifference {
  std::size_t update = 0;             ///< counted from 0
  std::string what;                   ///< "begun", "contacts", "work", ...
  std::optional<BodyPair> pair = {};  ///< that differs, where it is about one
  std::string first;                  ///< what the first run said, in few words
  std::string second;                 ///< what the second said

  bool operator==(const RecordingDifference&) const = default;
};

/// The first of what differs in the answers to one update, in the order of the lists of
/// RecordedAnswers and of the pairs in them; none if they are equal. Counters of work are compared
/// if both have them.
std::optional<RecordingDifference> first_difference(std::size_t update,
                                                    const RecordedAnswers& first,
                                                    const RecordedAnswers& second);

/// The same of what was done before an update: bodies that came and went, poses, settings. Shapes
/// are compared by their numbers, which are equal for equal histories.
std::optional<RecordingDifference> first_difference(std::size_t update,
                                                    const std::vector<RecordedChange>& first,
                                                    const std::vector<RecordedChange>& second);

/// How a recording is repeated.
struct RecordingReplaySettings {
  int threads = 1;        ///< as WorldSettings has it; no answer depends on it
  bool has_work = false;  ///< compares WorldWork, too: that of other versions differs
  bool skips = true;      ///< false: a world that skips nothing (WorldSettings), slowly
};

/// Does to a world of its own what was done to the recorded one, update by update, and says where
/// their answers part.
class RecordingReplay {
 public:
  /// Takes over the reader, of which nothing has been read but its start. Throws what the world
  /// throws that is made.
  explicit RecordingReplay(RecordingReader reader, const RecordingReplaySettings& settings = {});
  ~RecordingReplay();
  RecordingReplay(RecordingReplay&& other) noexcept;             ///< as its reader
  RecordingReplay& operator=(RecordingReplay&& other) noexcept;  ///< likewise

  /// Repeats the next update. False at the end of the recording. Throws as the reader and the world
  /// do; RecordingError, too, where the world gives a body another id than it had.
  bool advance();

  /// The update that was repeated last, as it was recorded.
  const RecordedStep& step() const;
  /// What differed in it: what was recorded first, what is now second.
  const std::optional<RecordingDifference>& difference() const;
  /// All that the world says to it now. Valid until the next call of advance().
  const WorldUpdate& update() const;
  /// The world after it.
  const World& world() const;
  /// To look up shapes, and how the recording ended.
  const RecordingReader& reader() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace graze
