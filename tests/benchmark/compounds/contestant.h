#pragma once

#include <graze/engine/mesh/voxels.h>
#include <graze/engine/world/placed_shape.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace graze::benchmark {

/// Many parts that are one body, in a frame of their own.
using Parts = std::vector<PlacedShape>;

/// What is asked beside a body that stands where its frame does: a shape, or a body of parts, in
/// each of many poses.
struct Asked {
  Parts parts;  ///< one for a shape
  std::vector<Pose> poses;
};

/// Boxes, balls and capsules at random in a cube of so many metres.
Parts random_parts(std::size_t count, double side);

/// A box of the size of a part, or so many parts around an origin, in poses of which about half
/// touch the others.
Asked random_asked(std::size_t parts, std::size_t poses, double side);

/// The surface of a ball, or all of it, in a grid about the origin whose edge is a power of two and
/// that has so many voxels along each side.
Voxels ball_of_voxels(std::uint32_t side, bool is_solid);

/// Who takes part: is there a point in common, pose by pose.
class BodyContestant {
 public:
  virtual ~BodyContestant() = default;
  virtual std::string name() const = 0;
  /// Makes the body, from nothing, and keeps it.
  virtual void build() = 0;
  /// Takes what is asked.
  virtual void take(const Asked& asked) = 0;
  virtual bool touches(const Pose& pose) = 0;
};

using Contestants = std::vector<std::unique_ptr<BodyContestant>>;

// Each of what is found; they refer to the parts and the voxels.
void add_graze(const Parts& parts, Contestants& contestants);
void add_graze(const Voxels& voxels, Contestants& contestants);
void add_bullet(const Parts& parts, Contestants& contestants);
void add_fcl(const Parts& parts, Contestants& contestants);
void add_fcl_octree(const Voxels& voxels, Contestants& contestants);

}  // namespace graze::benchmark
