#include <graze/engine/cli/recordings/recorded_pieces.h>
#include <graze/engine/world/compound.h>

#include <array>

namespace graze::cli {
namespace {

/// Holds the corners of a cube's faces, 1 where they lie at the upper plane, counter-clockwise from
/// outside; and the way to the neighbour beyond each.
struct CubeFace {
  std::array<int, 3> beyond;
  std::array<std::array<std::uint32_t, 3>, 4> corners;
};
constexpr std::array<CubeFace, 6> kCubeFaces{{
    {{-1, 0, 0}, {{{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}}}},
    {{1, 0, 0}, {{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}}},
    {{0, -1, 0}, {{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}}},
    {{0, 1, 0}, {{{0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}}}},
    {{0, 0, -1}, {{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}}},
    {{0, 0, 1}, {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}}},
}};

bool is_full(const VoxelMap& map, const Voxel& voxel, const std::array<int, 3>& beyond) {
  const std::array<int, 3> at = {voxel.i + beyond[0], voxel.j + beyond[1], voxel.k + beyond[2]};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (at[axis] < 0 || static_cast<std::uint32_t>(at[axis]) >= map.grid().counts[axis])
      return false;
  }
  return map.contains({static_cast<std::uint16_t>(at[0]), static_cast<std::uint16_t>(at[1]),
                       static_cast<std::uint16_t>(at[2])});
}

}  // namespace

Mesh outer_faces(const VoxelMap& map) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (const Voxel& voxel : map.voxels()) {
    for (const CubeFace& face : kCubeFaces) {
      if (is_full(map, voxel, face.beyond)) continue;
      const auto first = static_cast<std::uint32_t>(vertices.size());
      for (const std::array<std::uint32_t, 3>& corner : face.corners) {
        vertices.emplace_back(map.grid().plane(0, voxel.i + corner[0]),
                              map.grid().plane(1, voxel.j + corner[1]),
                              map.grid().plane(2, voxel.k + corner[2]));
      }
      triangles.push_back({first, first + 1, first + 2});
      triangles.push_back({first, first + 2, first + 3});
    }
  }
  return Mesh(vertices, triangles);
}

std::vector<RecordedPiece> pieces_of(const BodyShape& shape) {
  std::vector<RecordedPiece> pieces;
  if (const Shape* known = shape.shape()) {
    pieces.push_back({*known, Pose::Identity()});
  } else if (const Compound* compound = compound_of(shape)) {
    for (const std::uint32_t part : compound->parts())
      pieces.push_back({compound->part(part).shape, compound->part(part).pose, part});
  } else if (const VoxelMap* map = voxel_map_of(shape)) {
    pieces.push_back({outer_faces(*map), Pose::Identity()});
  }
  return pieces;
}

void RecordedBodies::take(const RecordedState& state) {
  shapes_.clear();
  for (const RecordedBody& body : state.bodies)
    shapes_[body.id] = body.shape;
}

void RecordedBodies::note(const std::vector<RecordedChange>& changes) {
  for (const RecordedChange& change : changes) {
    if (const auto* added = std::get_if<BodyAdded>(&change)) shapes_[added->id] = added->shape;
    if (const auto* other = std::get_if<BodyReshaped>(&change)) shapes_[other->id] = other->shape;
    if (const auto* removed = std::get_if<BodyRemoved>(&change)) shapes_.erase(removed->id);
    if (const auto* restored = std::get_if<WorldRestored>(&change)) take(*restored->state);
  }
}

}  // namespace graze::cli
