#include "data/generator/parts/thread.h"

#include <cmath>

namespace graze::generator {
namespace {

// No line of the bundled parts comes nearer to this limit than 0.4 micrometres, so that the
// rounding of the C library decides nothing; the tests hold the numbers of triangles fixed.
constexpr double kEndMargin = 0.02;

}  // namespace

const double kM8RangeMean = std::sqrt(5.6 * 11.2);

std::vector<ThreadLine> thread_lines(const ThreadProfile& profile, const Range& range,
                                     const ColumnAngle& angle) {
  const int per_turn = static_cast<int>(profile.points.size());
  const int first = static_cast<int>(std::floor(range.lower / profile.pitch)) - 2;
  const int last = static_cast<int>(std::ceil(range.upper / profile.pitch)) + 2;
  std::vector<ThreadLine> lines;
  for (int turn = first; turn <= last; ++turn) {
    for (int k = 0; k < per_turn; ++k) {
      const double turns = turn + static_cast<double>(angle.column) / angle.columns;
      const double z = profile.points[k].z + profile.pitch * turns;
      if (z > range.lower + kEndMargin && z < range.upper - kEndMargin) {
        lines.push_back({turn * per_turn + k, profile.points[k].r, z});
      }
    }
  }
  return lines;
}

}  // namespace graze::generator
