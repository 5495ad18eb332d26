#pragma once

#include <string>
#include <string_view>

namespace graze::files {

/// Returns the SHA-256 of the bytes as 64 digits, as `sha256sum` prints it (FIPS 180-4). Takes
/// linear time.
std::string sha256_of(std::string_view bytes);

}  // namespace graze::files
