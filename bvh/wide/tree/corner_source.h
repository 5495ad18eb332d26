#pragma once

#include <graze/bvh/build/reference.h>
#include <graze/bvh/value/local_frame.h>
#include <graze/bvh/wide/tree/corner_rows.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>

namespace graze::bvh {

/// The source of a WideTree's primitives, each as the hull of three points. What is given must
/// outlive this.
class CornerSource {
 public:
  using Corners = std::array<std::uint32_t, 3>;

  CornerSource(std::span<const Eigen::Vector3d> points, std::span<const Corners> primitives)
      : points_(points), primitives_(primitives) {}

  std::size_t size() const { return primitives_.size(); }

  /// Returns references to these primitives, with their boxes rounded outward in the frame (law 5);
  /// to all of them, in parallel, if none are named.
  References references(const LocalFrame& frame,
                        std::span<const std::uint32_t> primitives = {}) const;

  /// Returns the box of these primitives, rounded outward in the frame: that of all their
  /// references.
  Bounds bounds(const LocalFrame& frame, std::span<const std::uint32_t> primitives) const;

  /// Fills `rows`, which is as long, with these primitives' corners: in the frame, less `origin`.
  void fill(std::span<const std::uint32_t> primitives, const LocalFrame& frame,
            const double (&origin)[3], CornerRows& rows) const;

 private:
  std::span<const Eigen::Vector3d> points_;
  std::span<const Corners> primitives_;
};

}  // namespace graze::bvh
