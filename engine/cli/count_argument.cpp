#include <graze/engine/cli/count_argument.h>
#include <graze/engine/cli/usage_error.h>
#include <graze/engine/mesh/io/source.h>

#include <charconv>
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

}  // namespace graze::cli
