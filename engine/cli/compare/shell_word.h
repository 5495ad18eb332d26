#pragma once

#include <span>
#include <string>

namespace graze::cli {

/// Returns the text as one word for the shell, quoted where it must be. With control characters, or
/// bytes that are not UTF-8, it is a word for bash, ksh and zsh.
std::string shell_word(const std::string& text);

/// Returns such words after the name of this program.
std::string shell_line(std::span<const std::string> arguments);

}  // namespace graze::cli
