#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace graze::cases {

/// Writes the double as `-0x1.8p+1`: sign, one digit, the fraction without zeros at its end, the
/// binary exponent. The text is lossless, and the same on every machine and in every locale. The
/// value must be finite.
std::string to_hex_float(double value);

/// Reads `[+-]0xH[.H]p[+-]D`. Returns nothing for any other text, NaN and infinity included, and
/// for a number that no double equals: reading never rounds.
std::optional<double> parse_hex_float(std::string_view text);

}  // namespace graze::cases
