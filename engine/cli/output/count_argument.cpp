#include <graze/engine/cli/output/count_argument.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/files/source.h>

#include <charconv>
#include <cmath>
#include <system_error>

namespace graze::cli {

std::uint32_t parse_count(const std::string& text, const char* option, std::uint32_t lowest,
                          std::uint32_t highest) {
  std::uint32_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc() && stop == end && value >= lowest && value <= highest) return value;
  throw UsageError(std::string(option) + ": " + mesh_io::quoted(text) +
                   " is not a whole number from " + std::to_string(lowest) + " to " +
                   std::to_string(highest));
}

ArgumentCheck whole_number(std::uint64_t lowest, std::uint64_t highest) {
  return [=](const std::string& text) -> std::string {
    std::uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    const bool is_octal = text.size() > 1 && text[0] == '0';
    const bool is_whole = error == std::errc() && stop == end && !is_octal;
    if (is_whole && value >= lowest && value <= highest) return "";
    return mesh_io::quoted(text) + " is not a whole number from " + std::to_string(lowest) +
           " to " + std::to_string(highest);
  };
}

ArgumentCheck finite_number(Sign sign) {
  return [=](const std::string& text) -> std::string {
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    const bool is_number = error == std::errc() && stop == end && std::isfinite(value);
    const bool is_right = sign == Sign::Positive ? value > 0 : value >= 0;
    if (is_number && is_right) return "";
    return mesh_io::quoted(text) +
           (sign == Sign::Positive ? " is not a positive number" : " is not a number from 0 on");
  };
}

}  // namespace graze::cli
