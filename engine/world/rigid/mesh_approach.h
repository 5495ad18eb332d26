#pragma once

// Finds when a convex shape and a mesh come to each other. Private to engine/world.

#include <graze/engine/work.h>
#include <graze/engine/world/rigid/approach.h>
#include <graze/engine/world/shapes/pair_input.h>

#include <cstdint>
#include <optional>

namespace graze {

class TreeSweep;
struct NearTimes;

/// Says which triangles count: those that the shape does not touch at time 0, and does not slide
/// along. It slides along a triangle if it never gets deeper than `depth` behind the triangle's
/// plane, metres, as seen from the place of its middle at 0.
struct SlidingRule {
  double depth;
};

/// Finds the first time of the grid at which a convex shape may be as near to a triangle of a mesh
/// as the limit. It walks the tree towards a box around the shape in all directions in which it
/// turns. Relative to the mesh the box goes straight: slabs tell when it is near a node, and the
/// node that is near first is walked first. The box has room for how far turning takes the mesh.
/// Each triangle that is left is approached step by step, as far as the gap lasts.
class MeshApproach {
 public:
  static bool is_for(const MovingShape& convex, const MovingShape& mesh);

  /// Takes a shape, A, and a mesh, B, with their approach. All must outlive this.
  MeshApproach(const MovingShape& convex, const MovingShape& mesh, const Approach& approach,
               Work& work);

  /// Returns the first time, as a step of the grid, or the end of the grid if there is none. If the
  /// budget, a number of gaps, ends, it returns the time at which the box is first near any
  /// triangle. A rule may only be given for meshes that do not turn.
  std::uint64_t find_low(std::uint64_t budget, const std::optional<SlidingRule>& rule = {});
  bool is_out_of_budget() const { return is_out_of_budget_; }

  /// Returns the triangle that find_low() found.
  std::uint32_t found() const { return found_; }

 private:
  struct TimesOfNodes;
  /// The gap between the shape and a triangle, and how it closes.
  struct Gap {
    double lower;
    Closing closing;
  };

  Gap gap_at(std::uint64_t k, std::uint32_t triangle) const;

  void approach_triangle(std::uint32_t triangle, const NearTimes& times);
  bool slides_along(std::uint32_t triangle) const;
  double depth_behind(const Triangle& triangle, double t, const Eigen::Vector3d& normal) const;
  std::uint64_t step_before(double t) const;

  const MovingShape& convex_;
  const MovingShape& mesh_;
  const Mesh& triangles_;
  const Approach& approach_;
  Work& work_;
  RigidMotion relative_;
  std::optional<SlidingRule> rule_;
  std::uint64_t budget_ = 0;
  std::uint64_t low_ = 0;
  std::uint32_t found_ = 0;
  bool is_out_of_budget_ = false;
};

}  // namespace graze
