#include <graze/engine/cli/quote.h>

#include <fmt/format.h>

namespace graze::cli {

std::string one_line(std::string_view text) {
  std::string line;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '\n') {
      line += "\\n";
    } else if (c == '\r') {
      line += "\\r";
    } else if (c == '\t') {
      line += "\\t";
    } else if (code < 0x20 || code == 0x7f) {
      line += fmt::format("\\x{:02x}", code);
    } else {
      line += c;
    }
  }
  return line;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kMaxLength = 40;
  const bool is_short = text.size() <= kMaxLength;
  return "'" + one_line(text.substr(0, kMaxLength)) + (is_short ? "'" : "...'");
}

}  // namespace graze::cli
