#include <graze/engine/compare/run/baseline.h>

#include <algorithm>
#include <map>

namespace graze::compare {

BaselineDifference compare_to_baseline(std::span<const GrazePart> baseline,
                                       std::span<const GrazePart> parts) {
  std::map<std::size_t, const GrazePart*> old;
  for (const GrazePart& part : baseline)
    old[part.place] = &part;
  BaselineDifference difference;
  std::vector<double> ratios;
  for (const GrazePart& now : parts) {
    const auto at = old.find(now.place);
    const GrazePart* before = at == old.end() ? nullptr : at->second;
    if (at != old.end()) old.erase(at);
    if (before == nullptr || before->digest.empty() || now.digest.empty()) {
      difference.missing.push_back(now.place);
      continue;
    }
    if (now.digest != before->digest) difference.changed.push_back(now.place);
    if (before->time > 0) ratios.push_back(now.time / before->time);
  }
  if (!ratios.empty()) {
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    difference.time_ratio = *middle;
  }
  for (const auto& [place, ignored] : old)
    difference.missing.push_back(place);
  return difference;
}

}  // namespace graze::compare
