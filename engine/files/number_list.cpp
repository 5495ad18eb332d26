#include <graze/bvh/error.h>
#include <graze/engine/files/number_list.h>
#include <graze/engine/files/source.h>

#include <fast_float/fast_float.h>
#include <algorithm>
#include <cmath>
#include <system_error>

namespace graze::files {
namespace {

constexpr std::string_view kBlanks = " \t\n\r\v\f";
constexpr std::string_view kSeparators = " \t\n\r\v\f,";

[[noreturn]] void fail(const std::string& place, const std::string& why) {
  throw PoseError(place + ": " + why);
}

/// Returns the fields of a line: runs of characters that are neither blanks nor commas. A comma
/// stands between two fields.
std::vector<std::string_view> split(std::string_view text, const std::string& place) {
  std::vector<std::string_view> fields;
  bool is_comma_open = true;  // a comma here would have no field before it
  while (!(text = text.substr(std::min(text.find_first_not_of(kBlanks), text.size()))).empty()) {
    if (text.front() == ',') {
      if (is_comma_open) fail(place, "a comma without a number before it");
      is_comma_open = true;
      text.remove_prefix(1);
      continue;
    }
    const std::size_t length = std::min(text.find_first_of(kSeparators), text.size());
    fields.push_back(text.substr(0, length));
    text.remove_prefix(length);
    is_comma_open = false;
  }
  if (is_comma_open && !fields.empty()) fail(place, "a comma without a number after it");
  return fields;
}

double parse_number(std::string_view field, std::size_t number, const std::string& place) {
  // A plus sign is how some programs print numbers, though from_chars() refuses it.
  const bool has_plus = field.size() > 1 && field[0] == '+' && field[1] != '-';
  const char* const begin = field.data() + (has_plus ? 1 : 0);
  const char* const end = field.data() + field.size();
  double value = 0;
  const auto result = fast_float::from_chars(begin, end, value);
  const auto refuse = [&](const char* why) {
    fail(place, "number " + std::to_string(number) + ": " + mesh_io::quoted(field) + why);
  };
  if (result.ec == std::errc::invalid_argument || result.ptr != end) refuse(" is not a number");
  if (!std::isfinite(value)) refuse(" is not finite");
  return value;
}

}  // namespace

std::vector<double> parse_numbers(std::string_view text, const std::string& place) {
  std::vector<double> numbers;
  for (const std::string_view field : split(text, place))
    numbers.push_back(parse_number(field, numbers.size() + 1, place));
  return numbers;
}

}  // namespace graze::files
