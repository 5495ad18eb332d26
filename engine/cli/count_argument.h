#pragma once

#include <cstdint>
#include <string>

namespace graze::cli {

/// What --threads can be at most.
inline constexpr std::uint32_t kMaxThreads = 1024;

/// A whole number between these, both included. Decimal digits alone: the parser of options would
/// read 010 as eight. Throws UsageError, which names the option.
std::uint32_t parse_count(const std::string& text, const char* option, std::uint32_t lowest,
                          std::uint32_t highest);

}  // namespace graze::cli
