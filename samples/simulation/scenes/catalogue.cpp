#include "samples/simulation/scenes/catalogue.h"

#include <utility>

#include "samples/simulation/scenes/balances.h"
#include "samples/simulation/scenes/machines.h"
#include "samples/simulation/scenes/planks.h"
#include "samples/simulation/scenes/rolling.h"
#include "samples/simulation/scenes/stacks.h"
#include "samples/simulation/scenes/stairs.h"
#include "samples/simulation/scenes/terrains.h"

namespace graze::samples {

std::vector<Scene> all_scenes(const CatalogueSettings& settings) {
  std::vector<Scene> all;
  const auto add = [&](std::vector<Scene> family) {
    for (Scene& scene : family)
      all.push_back(std::move(scene));
  };
  for (const Surface surface : {Surface::Analytic, Surface::Mesh}) {
    add(stacks(surface, settings.extent));
    add(planks(surface, settings.extent));
    add({tipping_plank(surface)});
    add(stairs(surface, settings.extent));
    add({rolling_ball(surface, settings.extent), wheel_over_kerb(surface, settings.extent)});
    add({terrain(surface, settings.extent, settings.data)});
    add(balances(surface));
  }
  add({gears(settings.extent, settings.data), nut_on_bolt(0.01, settings.extent, settings.data),
       nut_on_bolt(0.3, settings.extent, settings.data)});
  return all;
}

std::optional<Scene> find_scene(const std::string& name, const CatalogueSettings& settings) {
  for (Scene& scene : all_scenes(settings)) {
    if (scene.name == name) return std::move(scene);
  }
  return std::nullopt;
}

}  // namespace graze::samples
