#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/record/coding/byte_writer.h>
#include <graze/engine/record/updates/answer_content.h>
#include <graze/engine/world/ids.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace graze::record {

/// Notes what was done to a world until the end of an update, as quickly as it can: copies of poses
/// and answers, and the rest, of which there is little, as bytes of the format.
class StepNotes {
 public:
  /// Says where poses stand in between the changes.
  struct Run {
    std::size_t at = 0;     ///< the place behind so many bytes of changes
    std::size_t count = 0;  ///< the number of bodies and of poses
    bool is_begin = false;  ///< true for bodies that come, whose poses stand in the bytes already
    std::uint32_t before = 0;  ///< the body that the change before was about
  };

  ByteWriter changes;   ///< the changes up to what the update said
  KeptAnswers answers;  ///< what the update said
  std::string blocks;   ///< blocks of new shapes, which are written before

  void clear() {
    changes.clear(), blocks.clear();
    runs_.clear(), bodies_.clear(), poses_.clear();
  }

  void note_begin(std::uint32_t body, const Pose& pose) {
    runs_.push_back({.at = changes.size(), .count = 1, .is_begin = true});
    bodies_.push_back(body);
    poses_.push_back(pose);
  }
  void note_moves(std::span<const BodyId> ids, std::span<const Pose> poses, std::uint32_t before) {
    runs_.push_back({.at = changes.size(), .count = ids.size(), .before = before});
    bodies_.reserve(bodies_.size() + ids.size());
    for (const BodyId& id : ids)
      bodies_.push_back(id.index);
    poses_.insert(poses_.end(), poses.begin(), poses.end());
  }

  std::span<const Run> runs() const { return runs_; }
  /// Return the bodies of all runs, and their poses, in order.
  std::span<const std::uint32_t> bodies() const { return bodies_; }
  std::span<const Pose> poses() const { return poses_; }

 private:
  std::vector<Run> runs_;
  std::vector<std::uint32_t> bodies_;
  std::vector<Pose> poses_;
};

}  // namespace graze::record
