#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cli/compare/markup.h>

#include <algorithm>

namespace graze::cli {

std::string escaped(const std::string& text) {
  std::string out;
  const std::string clean = cases::json_string(text);
  for (std::size_t i = 1; i + 1 < clean.size(); ++i) {
    const char c = clean[i];
    switch (c) {
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '&':
        out += "&amp;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\\':
        if (clean[i + 1] == '"' || clean[i + 1] == '\\') {
          out += clean[++i] == '"' ? "&quot;" : "\\";
          break;
        }
        [[fallthrough]];
      default:
        out += c;
    }
  }
  return out;
}

std::string escaped_lines(const std::string& text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    out += escaped(text.substr(at, end - at)) + '\n';
    at = end + 1;
  }
  return out;
}

}  // namespace graze::cli
