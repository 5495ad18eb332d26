#pragma once

#include <span>
#include <string>

namespace graze::cli {

/// The text as one word for the shell, quoted where it must be. With control characters, or bytes
/// that are no UTF-8, it is a word for bash, ksh and zsh.
std::string shell_word(const std::string& text);

/// Such words after the name of this program.
std::string shell_line(std::span<const std::string> arguments);

}  // namespace graze::cli
