#pragma once

#include <graze/bvh/build/reference.h>
#include <graze/bvh/value/local_frame.h>
#include <graze/bvh/wide/tree/corner_rows.h>

#include <cstdint>
#include <span>

namespace graze::bvh {

/// Where a WideTree gets its primitives from, each as the hull of three points.
class CornerSource {
 public:
  virtual ~CornerSource() = default;

  virtual std::size_t size() const = 0;

  /// References to these primitives, with their boxes rounded outward in the frame; to all of them,
  /// in parallel, if none are named.
  virtual References references(const LocalFrame& frame,
                                std::span<const std::uint32_t> primitives = {}) const = 0;

  /// The box of these primitives, rounded outward in the frame: that of all their references.
  virtual Bounds bounds(const LocalFrame& frame,
                        std::span<const std::uint32_t> primitives) const = 0;

  /// Fills `rows`, which is as long, with these primitives' corners: in the frame, less `origin`.
  virtual void fill(std::span<const std::uint32_t> primitives, const LocalFrame& frame,
                    const double (&origin)[3], CornerRows& rows) const = 0;
};

}  // namespace graze::bvh
