#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace graze::cli {

/// What --threads can be at most.
inline constexpr std::uint32_t kMaxThreads = 1024;

/// A whole number between these, both included. Decimal digits alone: the parser of options would
/// read 010 as eight. Throws UsageError, which names the option.
std::uint32_t parse_count(const std::string& text, const char* option, std::uint32_t lowest,
                          std::uint32_t highest);

/// What the parser of options asks about an argument: empty, or in few words what is wrong with it.
using ArgumentCheck = std::function<std::string(const std::string&)>;

/// A whole number between these, in decimal digits without a zero in front.
ArgumentCheck whole_number(std::uint64_t lowest, std::uint64_t highest);

enum class Sign { Positive, NotNegative };

/// A number with this sign that is finite.
ArgumentCheck finite_number(Sign sign);

}  // namespace graze::cli
