#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string_view>

#include <graze/bvh/aabb.h>
#include <graze/narrowphase/triangle.h>

namespace graze::oracle {

/// Which coordinates a corpus may use.
enum class Grid {
  Double,  ///< any double
  Float,   ///< only doubles that a float holds exactly
};

/// The nearest double of the grid. A finite value beyond the range of float stays what it is.
double on_grid(double value, Grid grid);

/// A stream of random numbers and shapes, the same on every machine: SplitMix64 (Steele, Lea and
/// Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014), with distributions of our
/// own and no function of libm that rounds. C++ leaves the order open in which the arguments of a
/// function and the sides of an operator are evaluated: draw from a Sampler once in an expression,
/// or within braces, which are evaluated from left to right.
class Sampler {
 public:
  Sampler(std::uint64_t seed, Grid grid) : state_(seed), grid_(grid) {}

  /// The stream for element `index` of the corpus called `name`.
  Sampler(std::string_view name, std::uint64_t index, Grid grid);

  Grid grid() const { return grid_; }
  std::uint64_t bits();
  int integer(int low, int high);          ///< low to high, both included
  bool one_in(int n);                      ///< true once in n times
  double sign();                           ///< -1 or 1
  double unit();                           ///< [0, 1), a multiple of 2^-53
  double symmetric();                      ///< [-1, 1)
  double magnitude(int low, int high);     ///< 2^e * [1, 2) with e from low to high
  double nudged(double x, int max_steps);  ///< x, up to max_steps neighbours on the grid away

  Eigen::Vector3d point();                 ///< symmetric() coordinates
  Eigen::Vector3d whole_point(int reach);  ///< integers from -reach to reach
  Eigen::Vector3d nudged(const Eigen::Vector3d& p, int max_steps);
  Triangle triangle();
  Triangle whole_triangle(int reach);
  Triangle nudged(const Triangle& t, int max_steps);
  Eigen::Vector3d point_in(const Triangle& t);  ///< up to rounding

  /// The same closed triangle, its vertices in a random order.
  Triangle shuffled(const Triangle& t);

 private:
  std::uint64_t state_;
  Grid grid_;
};

}  // namespace graze::oracle
