#include "data/generator/parts/gear.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace graze::generator {
namespace {

constexpr int kFilletSteps = 4;
constexpr int kInvoluteSteps = 7;

struct PlanePoint {
  double x;
  double y;
};

using Outline = std::vector<PlanePoint>;

PlanePoint polar(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

// Around one tooth by ascending angle: the middle of the gap before it, up one flank, the middle of
// the tip, down the other flank.
void add_tooth(Outline& outline, const SpurGear& gear, const std::vector<FlankPoint>& side,
               double middle) {
  outline.push_back(polar(gear.root_radius(), middle - std::numbers::pi / gear.teeth));
  for (auto p = side.begin(); p != side.end(); ++p) {
    outline.push_back(polar(p->radius, middle - p->angle));
  }
  outline.push_back(polar(gear.tip_radius(), middle));
  for (auto p = side.rbegin(); p != side.rend(); ++p) {
    outline.push_back(polar(p->radius, middle + p->angle));
  }
}

double tooth_middle(const SpurGear& gear, int tooth) {
  return 2 * std::numbers::pi * tooth / gear.teeth;
}

// The bore has a point below each gap, and one below each end of the root of each tooth.
Outline bore_outline(const GearBody& body, double root_angle) {
  Outline outline;
  for (int tooth = 0; tooth < body.gear.teeth; ++tooth) {
    const double middle = tooth_middle(body.gear, tooth);
    outline.push_back(polar(body.bore_radius, middle - std::numbers::pi / body.gear.teeth));
    outline.push_back(polar(body.bore_radius, middle - root_angle));
    outline.push_back(polar(body.bore_radius, middle + root_angle));
  }
  return outline;
}

using Loop = std::vector<std::uint32_t>;

Loop at_height(Surface& surface, const Outline& outline, double z) {
  Loop loop;
  for (const PlanePoint& p : outline)
    loop.push_back(surface.vertex({p.x, p.y, z}));
  return loop;
}

// A wall between two copies of a loop; its outside is to the right of the loop's direction.
void add_wall(Surface& surface, const Loop& lower, const Loop& upper) {
  for (std::size_t i = 0; i < lower.size(); ++i) {
    const std::size_t next = (i + 1) % lower.size();
    surface.quadrangle(lower[i], lower[next], upper[next], upper[i]);
  }
}

// A face seen from above: each tooth is a ladder from flank to flank, the ring below the teeth
// joins their feet and the gaps to the bore.
void add_face(Surface& surface, const Loop& outline, const Loop& bore, int teeth) {
  const std::size_t per_tooth = outline.size() / teeth;
  const std::size_t tip = per_tooth / 2;
  Loop ring;
  for (int tooth = 0; tooth < teeth; ++tooth) {
    const std::uint32_t* points = &outline[tooth * per_tooth];
    for (std::size_t i = 1; i + 1 < tip; ++i) {
      surface.quadrangle(points[i], points[i + 1], points[per_tooth - i - 1],
                         points[per_tooth - i]);
    }
    surface.triangle(points[tip - 1], points[tip], points[tip + 1]);
    ring.insert(ring.end(), {points[0], points[1], points[per_tooth - 1]});
  }
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t next = (i + 1) % ring.size();
    surface.quadrangle(ring[i], ring[next], bore[next], bore[i]);
  }
}

Loop reversed(const Loop& loop) {
  return {loop.rbegin(), loop.rend()};
}

// Reversing a loop turns a face over. So that it starts with a gap again and each tooth follows,
// the first gap moves back to the front.
Loop turned_over(const Loop& loop) {
  Loop result = {loop.front()};
  result.insert(result.end(), loop.rbegin(), loop.rend() - 1);
  return result;
}

}  // namespace

Surface make_gear(const GearBody& body) {
  const std::vector<FlankPoint> side = flank(body.gear, kFilletSteps, kInvoluteSteps);
  Outline outline;
  for (int tooth = 0; tooth < body.gear.teeth; ++tooth) {
    add_tooth(outline, body.gear, side, tooth_middle(body.gear, tooth));
  }
  const Outline bore = bore_outline(body, side.front().angle);

  Surface surface;
  std::vector<Loop> outlines;
  std::vector<Loop> bores;
  for (int layer = 0; layer <= body.layers; ++layer) {
    const double z = body.width * layer / body.layers - body.width / 2;
    outlines.push_back(at_height(surface, outline, z));
    bores.push_back(at_height(surface, bore, z));
  }
  for (int layer = 0; layer < body.layers; ++layer) {
    add_wall(surface, outlines[layer], outlines[layer + 1]);
    add_wall(surface, reversed(bores[layer]), reversed(bores[layer + 1]));
  }
  add_face(surface, outlines.back(), bores.back(), body.gear.teeth);
  add_face(surface, turned_over(outlines.front()), turned_over(bores.front()), body.gear.teeth);
  return surface;
}

}  // namespace graze::generator
