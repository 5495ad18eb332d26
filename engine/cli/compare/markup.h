#pragma once

#include <string>

namespace graze::cli {

/// Returns text for a page of HTML or XML: nothing in it is markup, and all bytes are UTF-8.
std::string escaped(const std::string& text);

/// Escapes each line of a text in the same way.
std::string escaped_lines(const std::string& text);

}  // namespace graze::cli
