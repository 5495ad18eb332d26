#pragma once

#include <graze/engine/record/coding/pose_track.h>
#include <graze/engine/record/write/step_notes.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace graze::record {

/// Makes blocks of notes, and hands them over.
class StepWriter {
 public:
  using Sink = std::function<void(std::string_view)>;

  explicit StepWriter(Sink sink) : sink_(std::move(sink)) {}

  /// Hands over blocks as they are. Throws what the sink throws.
  void hand_over(std::string_view blocks);
  /// Hands over the new shapes of an update, and then its block. Throws what the sink throws.
  void write(const StepNotes& notes);
  void close() noexcept { sink_ = nullptr; }

  std::size_t updates() const { return updates_; }
  std::uint64_t bytes() const { return bytes_; }

 private:
  void write_moves(std::span<const std::uint32_t> bodies, std::span<const Pose> poses,
                   std::uint32_t before);
  PoseTrack& track_of(std::uint32_t body);

  Sink sink_;
  std::vector<PoseTrack> tracks_;  ///< the tracks of poses, by body
  ByteWriter step_;
  std::string blocks_;
  std::size_t updates_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace graze::record
