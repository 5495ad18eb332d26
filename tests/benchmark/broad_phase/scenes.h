#pragma once

#include <graze/bvh/aabb.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace graze::benchmark {

/// SplitMix64 (Steele, Lea and Flood 2014), the same on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits();
  double unit();  // [0, 1)
  double between(double low, double high);
  double bell();                       // mean 0, variance 1, within 3: a sum of uniform ones
  Eigen::Vector3d point(double half);  // in a cube about the origin

 private:
  std::uint64_t state_;
};

/// Boxes that move, frame by frame; lengths in metres. The coordinates are floats, so that no peer
/// has to round and all of them can be asked for the same pairs.
class Scene {
 public:
  virtual ~Scene() = default;
  std::span<const Aabb> boxes() const { return boxes_; }
  std::span<const std::uint32_t> moved() const { return moved_; }  // in the last frame, ascending
  virtual void next_frame() = 0;

  /// What happens to those listed in moved().
  enum class Change { Moves, IsReplaced };
  virtual Change change() const { return Change::Moves; }

 protected:
  void place(std::uint32_t i, const Eigen::Vector3d& centre, const Eigen::Vector3d& half);
  void all_move();

  std::vector<Aabb> boxes_;
  std::vector<std::uint32_t> moved_;
};

/// S1 Brownian: sizes 0.5 to 1.5, each box overlaps four others, every one steps by up to 0.1 in
/// each coordinate.
/// S2 a pile: boxes at rest in layers on one floor as large as all, 15 % falling on it.
/// S3 as S1, one in a hundred moves, others in each frame.
/// S4 sizes over three decades, all moving by up to a tenth of their size.
/// S5 clusters of 500 overlapping boxes that cross the world at two box sizes a frame, and jitter.
/// R and a number, such as R100: boxes as in S1, of which one in so many goes in each frame, and
/// another comes elsewhere.
std::unique_ptr<Scene> make_scene(const std::string& name, std::uint32_t count, std::uint64_t seed);

}  // namespace graze::benchmark
