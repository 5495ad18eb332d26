#pragma once

#include <cstddef>
#include <vector>

namespace graze::stress {

/// How pairs of triangles fared at one value of what is swept.
struct SweepRow {
  double value = 0;  ///< scale in metres, offset in metres, or width of a needle of length 1
  std::size_t cases = 0;
  std::size_t hits = 0;   ///< by the referee
  std::size_t exact = 0;  ///< that the floating-point stage left unsure
  std::size_t wrong = 0;  ///< answers of graze that are not the referee's
};

/// Triangles on a small lattice, scaled by 1e-12 to 1e12 and placed at random, at offsets up to
/// `offset` times the scale.
std::vector<SweepRow> sweep_scales(double offset, std::size_t cases);

/// The same triangles of about a metre, rotated, at offsets from 0 to 1e9 metres.
std::vector<SweepRow> sweep_offsets(std::size_t cases);

/// Triangles of length 1 and widths from 1e-3 down to 1e-17, brought together on their long edges.
std::vector<SweepRow> sweep_needles(std::size_t cases);

}  // namespace graze::stress
