#pragma once

#include <graze/engine/record/recording.h>

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <memory>
#include <string>

namespace graze {

/// Says how a recording ends, as far as it has been read.
enum class RecordingEnd : std::uint8_t {
  NotReached,  ///< there may be more
  Complete,    ///< its writer has said that there is no more
  CutOff       ///< its writer did not come to the end: it was killed, or still writes
};

/// Reads a recording update by update, format version 1 (format.md), in one pass and with no more
/// in memory than its shapes and one update. A file whose writer was killed reads up to its last
/// whole update; whatever is damaged is refused: each block has a checksum.
class RecordingReader {
 public:
  /// Reads the head and what the world was. Throws RecordingError, with file and byte, for a file
  /// that is no recording, is of another version, is damaged, or ends before there is a world.
  explicit RecordingReader(const std::filesystem::path& file);
  /// Reads a recording from a stream; errors begin with `name`.
  RecordingReader(std::unique_ptr<std::istream> stream, std::string name);
  ~RecordingReader();
  RecordingReader(RecordingReader&& other) noexcept;  ///< a reader that was moved from can be
                                                      ///< destroyed or assigned to
  RecordingReader& operator=(RecordingReader&& other) noexcept;  ///< a reader that was moved from
                                                                 ///< can be destroyed or assigned
                                                                 ///< to

  /// Returns what the recording says of itself.
  const RecordingHead& head() const;
  /// Returns what the world was when the recording began.
  const RecordedState& start() const;

  /// Reads the next update, or returns nullptr at the end: end() then says which. The update is
  /// valid until the next call. Throws RecordingError for a damaged block; after that every call
  /// does.
  const RecordedStep* next();

  /// Returns how the recording ended, if it has.
  RecordingEnd end() const;
  /// Returns how many bytes were read so far: for a recording that is cut off, how many belong to
  /// whole blocks.
  std::uint64_t bytes() const;

  /// Return how many shapes were read so far, and one of them: a Shape (BodyShape::shape()), a
  /// Compound (compound_of()) or a map of voxels (voxel_map_of()). Throws InputError for a number
  /// that is none.
  std::size_t shape_count() const;
  const std::shared_ptr<const BodyShape>& shape(std::uint32_t number) const;

 private:
  friend class RecordingReplay;
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace graze
