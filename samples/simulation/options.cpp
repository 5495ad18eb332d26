#include "samples/simulation/options.h"

#include <charconv>
#include <string_view>

namespace graze::samples {
namespace {

/// Returns the whole text as a number, or nothing if it is not one.
template <typename T>
std::optional<T> number_of(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<SimulationOptions> simulation_options(int argc, char** argv) {
  if (argc < 2 || argc % 2 != 0) return std::nullopt;
  SimulationOptions options;
  options.data = argv[1];
  for (int i = 2; i < argc; i += 2) {
    const std::string_view name = argv[i];
    const std::string_view value = argv[i + 1];
    if (name == "--bodies") {
      options.bodies = number_of<int>(value).value_or(0);
    } else if (name == "--seconds") {
      options.seconds = number_of<double>(value).value_or(0);
    } else if (name == "--shot") {
      options.shot = number_of<double>(value).value_or(-1);
    } else if (name == "--seed") {
      const std::optional<std::uint64_t> seed = number_of<std::uint64_t>(value);
      if (!seed) return std::nullopt;
      options.seed = *seed;
    } else if (name == "--gltf") {
      options.gltf = value;
    } else if (name == "--picture") {
      options.picture = value;
    } else if (name == "--record") {
      options.record = value;
    } else {
      return std::nullopt;
    }
  }
  const bool is_sound = options.bodies > 0 && options.bodies <= 100000 && options.seconds > 0 &&
                        options.seconds <= 1e5 && options.shot >= 0 && options.shot <= 1e4;
  return is_sound ? std::optional(options) : std::nullopt;
}

}  // namespace graze::samples
