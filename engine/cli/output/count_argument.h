#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace graze::cli {

/// The largest number that --threads takes.
inline constexpr std::uint32_t kMaxThreads = 1024;

/// Reads a whole number between these, both included. It takes decimal digits alone: the parser of
/// options would read 010 as eight. Throws UsageError, which names the option.
std::uint32_t parse_count(const std::string& text, const char* option, std::uint32_t lowest,
                          std::uint32_t highest);

/// Answers the parser of options about an argument: empty, or in few words what is wrong with it.
using ArgumentCheck = std::function<std::string(const std::string&)>;

/// Accepts a whole number between these, in decimal digits without a zero in front.
ArgumentCheck whole_number(std::uint64_t lowest, std::uint64_t highest);

enum class Sign { Positive, NotNegative };

/// Accepts a finite number with this sign.
ArgumentCheck finite_number(Sign sign);

}  // namespace graze::cli
