#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <graze/engine/cli/recordings/recording_file.h>
#include <graze/engine/record/replay_recording.h>
#include <graze/engine/world/voxel_map.h>

namespace graze::cli {

/// Holds a shape that is seen of a body: all of it, or a part.
struct RecordedPiece {
  Shape shape;
  Pose pose;  ///< the pose in the body's frame
  std::optional<std::uint32_t> part = {};
};

/// Returns what is seen of a body's shape: the parts of a compound, the mesh of the outer faces of
/// a map of voxels.
std::vector<RecordedPiece> pieces_of(const BodyShape& shape);

/// Returns the faces of full voxels beside empty ones, four vertices each.
Mesh outer_faces(const VoxelMap& map);

/// Holds a body in the shape that it had for a while.
struct RecordedLook {
  BodyId id;
  std::uint32_t shape = 0;
  friend auto operator<=>(const RecordedLook&, const RecordedLook&) = default;
};

/// Says which bodies are there, in which shapes, as changes tell it.
class RecordedBodies {
 public:
  explicit RecordedBodies(const RecordedState& start) { take(start); }
  void note(const std::vector<RecordedChange>& changes);
  /// Returns the shapes, ascending by id.
  const std::map<BodyId, std::uint32_t>& shapes() const { return shapes_; }

 private:
  void take(const RecordedState& state);

  std::map<BodyId, std::uint32_t> shapes_;
};

}  // namespace graze::cli
