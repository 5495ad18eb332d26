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

/// A shape that is seen of a body: all of it, or a part.
struct RecordedPiece {
  Shape shape;
  Pose pose;  ///< in the body's frame
  std::optional<std::uint32_t> part = {};
};

/// What is seen of a body's shape: of a compound its parts, of a map of voxels the mesh of its
/// outer faces.
std::vector<RecordedPiece> pieces_of(const BodyShape& shape);

/// The faces of full voxels beside empty ones, four vertices each.
Mesh outer_faces(const VoxelMap& map);

/// A body in the shape that it had for a while.
struct RecordedLook {
  BodyId id;
  std::uint32_t shape = 0;
  friend auto operator<=>(const RecordedLook&, const RecordedLook&) = default;
};

/// Which bodies are there, in which shapes, as changes tell it.
class RecordedBodies {
 public:
  explicit RecordedBodies(const RecordedState& start) { take(start); }
  void note(const std::vector<RecordedChange>& changes);
  /// Ascending by id.
  const std::map<BodyId, std::uint32_t>& shapes() const { return shapes_; }

 private:
  void take(const RecordedState& state);

  std::map<BodyId, std::uint32_t> shapes_;
};

}  // namespace graze::cli
