#include <graze/engine/cli/outlines/scale_bar.h>

#include <fmt/format.h>
#include <array>
#include <cmath>
#include <utility>

namespace graze::cli {
namespace {

/// Returns "2 mm" for 2e-3: words from a nanometre to a kilometre, beyond that powers of ten.
std::string in_units(int digit, int exponent) {
  constexpr std::array<std::pair<int, const char*>, 5> kUnits = {
      {{3, "km"}, {0, "m"}, {-3, "mm"}, {-6, "\u00b5m"}, {-9, "nm"}}};
  if (exponent >= 6 || exponent < -9) return fmt::format("{}e{} m", digit, exponent);
  for (const auto& [unit, name] : kUnits) {
    if (exponent < unit) continue;
    int number = digit;
    for (int i = unit; i < exponent; ++i)
      number *= 10;
    return fmt::format("{} {}", number, name);
  }
  return "";
}

}  // namespace

ScaleBar scale_bar(double most) {
  if (!(most > 0) || !std::isfinite(most)) return {};
  int exponent = static_cast<int>(std::floor(std::log10(most)));
  if (std::pow(10.0, exponent) > most) --exponent;
  for (const int digit : {5, 2, 1}) {
    const double length = digit * std::pow(10.0, exponent);
    if (length <= most && length > 0) return {length, in_units(digit, exponent)};
  }
  return {};
}

}  // namespace graze::cli
