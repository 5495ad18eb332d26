#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/record/coding/byte_reader.h>
#include <graze/engine/record/coding/byte_writer.h>

#include <array>
#include <cstdint>

namespace graze::record {

/// Keeps the last poses of a body, and guesses where it is next. Writer and reader guess alike, in
/// operations that are each rounded once, so that what is written is how far the guess is off.
///
/// A body that turns steadily keeps turning by R_1 R_0^T, the third column is the cross product of
/// the other two, and the origin goes on straight or along a parabola: whichever would have been
/// nearer the last time. So free flight takes a byte or two for each number.
class PoseTrack {
 public:
  /// Begins at a pose, of which nothing can be guessed.
  void begin(const Pose& pose);

  void write(const Pose& pose, ByteWriter& to);
  Pose read(ByteReader& from);

 private:
  using Columns = std::array<double, 6>;

  /// Guesses the first two columns.
  Columns guessed_turn() const;
  std::array<double, 3> guessed_column(const Columns& turn) const;
  std::array<double, 3> guessed_place() const;
  void learn(const std::array<double, 12>& numbers);

  std::array<double, 9> turn_{}, turn_before_{};  ///< column by column
  std::array<double, 3> place_{}, place_before_{}, place_long_before_{};
  std::uint8_t known_ = 0;  ///< the number of poses, up to three
  bool is_still_ = false;   ///< true if the last two are turned alike
  bool is_curved_ = false;
};

/// Write and read a pose by itself: twelve numbers, column by column.
void write_pose(const Pose& pose, ByteWriter& to);
Pose read_pose(ByteReader& from);

}  // namespace graze::record
