#include "data/generator/parts/link.h"

#include <vector>

#include "data/generator/parts/circle.h"

namespace graze::generator {
namespace {

// 32 sides around the wire, 32 steps around each half circle, 4 along each leg.
constexpr int kWireHalvings = 3;
constexpr int kBendHalvings = 4;
constexpr int kLegSteps = 4;

/// A cut across the wire: its middle, and which way is outwards in the plane of the link.
struct Section {
  CirclePoint middle;
  CirclePoint outwards;
};

// Counter-clockwise from the end of the lower leg.
std::vector<Section> sections(const ChainLink& link) {
  const std::vector<CirclePoint> circle = unit_circle(kBendHalvings);
  const std::size_t quarter = circle.size() / 4;
  const double radius = link.bend_radius();
  std::vector<Section> result;
  for (double side : {1.0, -1.0}) {
    for (std::size_t i = 0; i <= 2 * quarter; ++i) {
      const CirclePoint& p = circle[(i + 3 * quarter) % circle.size()];
      result.push_back({{side * (link.half_leg() + radius * p.x), side * (radius * p.y)},
                        {side * p.x, side * p.y}});
    }
    for (int i = 1; i < kLegSteps; ++i) {
      const double x = link.half_leg() * (kLegSteps - 2 * i) / kLegSteps;
      result.push_back({{side * x, side * radius}, {0, side}});
    }
  }
  return result;
}

}  // namespace

Surface make_link(const ChainLink& link) {
  const std::vector<CirclePoint> wire = unit_circle(kWireHalvings);
  Surface surface;
  std::vector<std::vector<std::uint32_t>> rings;
  for (const Section& section : sections(link)) {
    auto& ring = rings.emplace_back();
    for (const CirclePoint& p : wire) {
      const double out = link.wire / 2 * p.x;
      ring.push_back(
          surface.vertex({section.middle.x + out * section.outwards.x,
                          section.middle.y + out * section.outwards.y, link.wire / 2 * p.y}));
    }
  }
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const auto& here = rings[i];
    const auto& next = rings[(i + 1) % rings.size()];
    for (std::size_t j = 0; j < wire.size(); ++j) {
      const std::size_t k = (j + 1) % wire.size();
      surface.quadrangle(here[j], next[j], next[k], here[k]);
    }
  }
  return surface;
}

}  // namespace graze::generator
