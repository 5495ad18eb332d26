#include "data/generator/parts/nut.h"

#include <algorithm>
#include <cmath>

#include "data/generator/parts/hexagon.h"
#include "data/generator/parts/lathe.h"
#include "data/generator/parts/thread.h"

namespace graze::generator {
namespace {

// ISO 4032 for M8: height m, width across flats s; countersink 120 degrees to d_a = 1.08 d.
constexpr double kHeight = 6.8;
constexpr Hexagon kOutside{13};
constexpr double kSinkRadius = 1.08 * kM8.diameter / 2;
const double kSinkSlope = std::sqrt(3.0);

// Chords of the bore pass inside the true cylinder by r (1 - cos(pi / 120)) = 0.0014 mm at r = 4
// mm. The pitch diameters in the middle of 6H and 6g differ by 0.167 mm, so that the flanks clear
// each other by 0.167 / 2 * sin 30 = 0.042 mm, thirty times as much.
constexpr int kColumns = 120;

double shaped_radius(double r, double z) {
  const double depth = std::min(z, kHeight - z);
  return std::max(r, kSinkRadius - depth * kSinkSlope);
}

void add_outside(Column& column, int index) {
  const double outside = kOutside.radius(index, kColumns);
  const double depth = kOutside.chamfer_depth(outside);
  column.push_back({0, 0, kSinkRadius, 0});
  column.push_back({0, 1, kOutside.chamfer_radius(), 0});
  column.push_back({0, 2, outside, depth});
  column.push_back({0, 3, outside, kHeight - depth});
  column.push_back({0, 4, kOutside.chamfer_radius(), kHeight});
  column.push_back({0, 5, kSinkRadius, kHeight});
}

}  // namespace

Surface make_nut() {
  const ThreadProfile profile = internal_profile(kM8, kM8RangeMean);
  std::vector<Column> columns(kColumns);
  for (int i = 0; i < kColumns; ++i) {
    add_outside(columns[i], i);
    // The outline goes up outside and down through the bore: lines count downwards here.
    std::vector<ThreadLine> lines = thread_lines(profile, {0, kHeight}, {i, kColumns});
    std::reverse(lines.begin(), lines.end());
    for (const ThreadLine& line : lines) {
      columns[i].push_back({1, -line.index, shaped_radius(line.r, line.z), line.z});
    }
    columns[i].push_back({2, 0, kSinkRadius, 0});
  }
  return turn_on_lathe(columns, {1, -static_cast<int>(profile.points.size())});
}

}  // namespace graze::generator
