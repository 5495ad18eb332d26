#pragma once

#include <string>
#include <string_view>

namespace graze::cli {

/// `text` on one line: control characters become \n, \r, \t or \xNN.
std::string one_line(std::string_view text);

/// `text` in single quotes, on one line and cut short after 40 characters, for messages.
std::string in_quotes(std::string_view text);

}  // namespace graze::cli
