#include <graze/engine/cli/shell_word.h>

namespace graze::cli {

std::string shell_word(const std::string& text) {
  constexpr const char* kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./,=+-";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') {
      out += "'\\''";
    } else {
      out += c;
    }
  }
  return out + "'";
}

std::string shell_line(std::span<const std::string> arguments) {
  std::string line = "graze";
  for (const std::string& argument : arguments) {
    line += ' ';
    line += shell_word(argument);
  }
  return line;
}

}  // namespace graze::cli
