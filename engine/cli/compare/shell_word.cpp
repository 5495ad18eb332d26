#include <graze/engine/cli/compare/shell_word.h>
#include <graze/engine/files/source.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace graze::cli {
namespace {

/// Returns $'...', which bash, ksh and zsh read: every byte that is not printable ASCII as \xNN.
std::string escaped_word(const std::string& text) {
  std::string out = "$'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') {
      out += fmt::format("\\{}", c);
    } else if (c >= ' ' && c <= '~') {
      out += c;
    } else {
      out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    }
  }
  return out + "'";
}

/// True if a terminal, or a page, shows the text as it is.
bool is_shown_as_it_is(const std::string& text) {
  if (mesh_io::printable(text) != text) return false;
  try {
    static_cast<void>(nlohmann::json(text).dump());
    return true;
  } catch (const nlohmann::json::type_error&) {
    return false;  // that is not UTF-8
  }
}

}  // namespace

std::string shell_word(const std::string& text) {
  constexpr const char* kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./,=+-";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  if (!is_shown_as_it_is(text)) return escaped_word(text);
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
