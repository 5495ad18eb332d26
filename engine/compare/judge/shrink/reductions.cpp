#include <graze/engine/compare/judge/shrink/reductions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace graze::compare {

Indices all_indices(std::size_t count) {
  Indices indices(count);
  std::iota(indices.begin(), indices.end(), 0U);
  return indices;
}

bool take_away(Indices& indices, const std::function<bool(const Indices&)>& still_does) {
  const std::size_t before = indices.size();
  for (std::size_t step = (indices.size() + 1) / 2; step > 0 && indices.size() > 1;) {
    bool is_smaller = false;
    for (std::size_t first = 0; first < indices.size() && indices.size() > 1;) {
      const std::size_t last = std::min(first + step, indices.size());
      Indices rest(indices.begin(), indices.begin() + static_cast<std::ptrdiff_t>(first));
      rest.insert(rest.end(), indices.begin() + static_cast<std::ptrdiff_t>(last), indices.end());
      if (!rest.empty() && still_does(rest)) {
        indices = std::move(rest);
        is_smaller = true;
      } else {
        first = last;
      }
    }
    step = step == 1 && !is_smaller ? 0 : std::max<std::size_t>(step / 2, 1);
  }
  return indices.size() < before;
}

void shorten(double value, const std::function<bool(double)>& will_do) {
  for (const int digits : {0, 1, 4, 12, 24}) {
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    const double coarse =
        digits == 0 ? 0
                    : std::ldexp(std::nearbyint(std::ldexp(fraction, digits)), exponent - digits);
    // Fewer digits may round up beyond the largest double.
    if (!std::isfinite(coarse)) continue;
    if (coarse == value || will_do(coarse)) return;
  }
}

}  // namespace graze::compare
