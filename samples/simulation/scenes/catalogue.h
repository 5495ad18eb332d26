#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "samples/simulation/scenes/scene.h"

namespace graze::samples {

/// Says which scenes are meant.
struct CatalogueSettings {
  Extent extent = Extent::Small;
  std::filesystem::path data = "data";  ///< the folder of the bundled data
};

/// Returns all of them, each kind of body as shapes and as meshes. Throws as load_mesh() does.
std::vector<Scene> all_scenes(const CatalogueSettings& settings);

/// Returns the scene of that name, or nothing.
std::optional<Scene> find_scene(const std::string& name, const CatalogueSettings& settings);

}  // namespace graze::samples
