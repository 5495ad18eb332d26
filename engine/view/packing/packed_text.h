#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace graze::view {

/// A browser keeps fewer packed bytes than these as one text.
inline constexpr std::size_t kMostPackedBytes = std::size_t{1} << 28;

/// Returns the bytes packed by gzip, without a name and a time: the same bytes give the same.
/// Throws InputError for what packs to more than kMostPackedBytes.
std::string gzipped(std::string_view bytes);

/// Returns the bytes in base64 (RFC 4648), with padding.
std::string base64(std::string_view bytes);

/// Returns the text as it stands between tags, or between quotes within one.
std::string html_text(std::string_view text);

}  // namespace graze::view
