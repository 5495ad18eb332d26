#pragma once

#include <string>
#include <string_view>

namespace graze::files {

/// The SHA-256 of the bytes as 64 digits, what `sha256sum` prints (FIPS 180-4). Linear time.
std::string sha256_of(std::string_view bytes);

}  // namespace graze::files
