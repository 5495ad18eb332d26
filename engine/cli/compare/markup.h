#pragma once

#include <string>

namespace graze::cli {

/// Text for a page of HTML or XML: nothing in it is markup, and no byte is left that is no UTF-8.
std::string escaped(const std::string& text);

/// The same of each of its lines.
std::string escaped_lines(const std::string& text);

}  // namespace graze::cli
