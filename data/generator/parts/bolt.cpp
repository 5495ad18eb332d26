#include "data/generator/parts/bolt.h"

#include <algorithm>
#include <cmath>

#include "data/generator/parts/hexagon.h"
#include "data/generator/parts/lathe.h"
#include "data/generator/parts/thread.h"

namespace graze::generator {
namespace {

// ISO 4017 for M8: nominal head height k and width across flats s, washer face c and d_w, radius r.
constexpr double kLength = 20;
constexpr double kHeadHeight = 5.3;
constexpr Hexagon kHead{13};
constexpr double kWasherHeight = 0.4;
constexpr double kWasherRadius = 11.63 / 2;
constexpr double kFillet = 0.4;

// A rolled thread begins on a blank about as thick as the pitch diameter. It reaches its full depth
// 3P above the head (ISO 3508 allows a run-out a <= 3P).
constexpr double kNeckEnd = 2 * kM8.pitch;
constexpr double kFullThread = 3 * kM8.pitch;

// Chamfered end (ISO 4753): 45 degrees, down to below the thread's root.
constexpr double kTipRadius = 3.0;

// Inscribed chords pass the true cylinder by r (1 - cos(pi / 84)) = 0.0028 mm at r = 4 mm. On the
// bolt this adds to the clearance of its flanks, which is 0.042 mm (see nut.cpp).
constexpr int kColumns = 84;

double neck_radius() {
  return kM8.pitch_diameter() / 2 - 0.05;
}

double run_out(double z) {
  const double t = std::clamp((z - kNeckEnd) / (kFullThread - kNeckEnd), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

double shaped_radius(double r, double z) {
  const double threaded = neck_radius() + run_out(z) * (r - neck_radius());
  return std::min(threaded, kTipRadius + (kLength - z));
}

void add_head(Column& column, int index) {
  const double outside = kHead.radius(index, kColumns);
  const double neck = neck_radius();
  int line = 0;
  const auto add = [&](double r, double z) { column.push_back({0, line++, r, z}); };
  add(0, -kHeadHeight);
  add(kHead.chamfer_radius(), -kHeadHeight);
  add(outside, -kHeadHeight + kHead.chamfer_depth(outside));
  add(outside, -kWasherHeight);
  add(kWasherRadius, -kWasherHeight);
  add(kWasherRadius, 0);
  for (double part : {0.0, 1.0 / 3, 2.0 / 3, 1.0}) {
    const double angle = part * std::acos(0.0);
    add(neck + kFillet * (1 - std::sin(angle)), kFillet * (1 - std::cos(angle)));
  }
  add(neck, kNeckEnd);
}

}  // namespace

Surface make_bolt() {
  const ThreadProfile profile = external_profile(kM8, kM8RangeMean);
  std::vector<Column> columns(kColumns);
  for (int i = 0; i < kColumns; ++i) {
    add_head(columns[i], i);
    for (const ThreadLine& line : thread_lines(profile, {kNeckEnd, kLength}, {i, kColumns})) {
      columns[i].push_back({1, line.index, shaped_radius(line.r, line.z), line.z});
    }
    columns[i].push_back({2, 0, kTipRadius, kLength});
    columns[i].push_back({2, 1, 0, kLength});
  }
  return turn_on_lathe(columns, {1, static_cast<int>(profile.points.size())});
}

}  // namespace graze::generator
