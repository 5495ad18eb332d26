#pragma once

#include <filesystem>
#include <string>

namespace graze::tests {

enum class Device { Null, Full };

/// A device on which a test may try whether it is replaced by a file: that of the system for users
/// who could not do that, and for the superuser one of its own in `folder`. Empty if there is none.
std::string spare_device(Device device, const std::filesystem::path& folder);

}  // namespace graze::tests
