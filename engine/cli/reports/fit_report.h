#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <graze/engine/mesh/fit.h>
#include <nlohmann/json_fwd.hpp>

namespace graze::cli {

/// Returns how well volumes fit a mesh, for JSON.
nlohmann::ordered_json fit_object(const MeshFit& fit);

/// Returns the same as lines for people, each a name and what stands beside it; without a fit it is
/// one line that says why.
std::vector<std::pair<std::string, std::string>> fit_lines(const std::optional<MeshFit>& fit);

}  // namespace graze::cli
