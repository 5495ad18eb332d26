#include <graze/engine/cases/text/hex_float.h>
#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/compare/run/advice/plain_case.h>

#include <algorithm>
#include <optional>

namespace graze::compare {
namespace {

/// Returns the place behind the quote that ends the string which begins at `at`.
std::size_t end_of_string(std::string_view json, std::size_t at) {
  for (++at; at < json.size() && json[at] != '"'; ++at)
    at += json[at] == '\\';
  return std::min(at + 1, json.size());
}

}  // namespace

std::string with_plain_numbers(std::string_view json) {
  std::string out;
  for (std::size_t at = 0; at < json.size();) {
    if (json[at] != '"') {
      out += json[at++];
      continue;
    }
    const std::size_t end = end_of_string(json, at);
    const std::string_view string = json.substr(at, end - at);
    std::optional<double> number;
    if (string.size() > 2) number = cases::parse_hex_float(string.substr(1, string.size() - 2));
    out += number ? cases::json_plain_number(*number) : std::string(string);
    at = end;
  }
  return out;
}

}  // namespace graze::compare
