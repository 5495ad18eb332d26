#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cli/compare/markup.h>

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

}  // namespace graze::cli
