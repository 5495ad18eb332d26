#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace graze::files {

/// Returns the numbers of a text, separated by blanks or commas, each rounded once to double.
/// Throws PoseError, which begins with `place` and counts numbers from 1, for what is not a finite
/// number.
std::vector<double> parse_numbers(std::string_view text, const std::string& place);

}  // namespace graze::files
