#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace graze::compare {

/// Returns bytes as text (RFC 4648, section 4), padded to a multiple of four.
std::string to_base64(std::string_view bytes);

/// Returns the bytes of such a text, and nothing for any other text.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace graze::compare
