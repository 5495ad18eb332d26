#pragma once

#include <graze/bvh/pose.h>
#include <graze/bvh/ray.h>
#include <graze/engine/world/shape.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace graze::benchmark {

/// A grid of heights a metre apart, bodies that lie on it, and where they are in each frame.
struct Terrain {
  std::uint32_t side = 0;  ///< heights along each side
  std::vector<float> heights;
  std::vector<Shape> bodies;
  std::vector<std::vector<Pose>> frames;
  std::vector<Ray> rays;
};

/// Hills of some metres, bodies a little in the ground that move by centimetres a frame, and rays
/// that come down at a slant.
Terrain make_terrain(std::uint32_t side, std::size_t bodies, std::size_t rays);

/// Who takes part.
class FieldContestant {
 public:
  virtual ~FieldContestant() = default;
  virtual std::string name() const = 0;
  /// Makes the terrain; returns the bytes that it takes, or 0 where nobody says.
  virtual std::size_t build(const Terrain& terrain) = 0;
  /// Puts the bodies there.
  virtual void place(const Terrain& terrain) = 0;
  /// Moves all bodies, and finds their contacts with the ground; how many bodies have some.
  virtual std::size_t step(const std::vector<Pose>& frame) = 0;
  /// How many rays hit.
  virtual std::size_t cast(std::span<const Ray> rays) = 0;
};

std::unique_ptr<FieldContestant> make_graze_field();
std::unique_ptr<FieldContestant> make_graze_mesh();
std::unique_ptr<FieldContestant> make_bullet();

}  // namespace graze::benchmark
