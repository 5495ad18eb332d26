#pragma once

#include <filesystem>
#include <string>

namespace graze::cases {

/// Returns the file that a path leads to, once it is sure to lie in the folder, at whatever depth.
/// Throws CaseError without a place for a path that is absolute or goes upwards, and for a link
/// that leads out of the folder; `owner` is whose folder it is, for the message: "case".
std::filesystem::path find_inside(const std::filesystem::path& folder, const std::string& path,
                                  const char* owner);

}  // namespace graze::cases
