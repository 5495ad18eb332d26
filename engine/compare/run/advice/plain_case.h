#pragma once

#include <string>
#include <string_view>

namespace graze::compare {

/// Returns the JSON of a case with plain numbers in place of hex floats, of as many digits as read
/// back as the same double: every reader of JSON knows these.
std::string with_plain_numbers(std::string_view json);

}  // namespace graze::compare
