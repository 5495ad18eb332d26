#include <graze/engine/compare/run/record/baseline.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace graze::compare {
namespace {

const SaidThere* find(std::span<const SaidThere> list, const std::string& engine) {
  const auto at = std::find_if(list.begin(), list.end(),
                               [&](const SaidThere& each) { return each.engine == engine; });
  return at == list.end() ? nullptr : &*at;
}

}  // namespace

Baseline::Held& Baseline::held(const std::string& engine) {
  const auto at = std::find_if(engines_.begin(), engines_.end(),
                               [&](const Held& each) { return each.change.engine == engine; });
  if (at != engines_.end()) return *at;
  engines_.emplace_back();
  engines_.back().change.engine = engine;
  return engines_.back();
}

bool Baseline::is_same(const SaidThere& before, const SaidThere& now) const {
  if (before.digest == now.digest) return true;
  if (!(tolerance_ > 0) || !before.value || !now.value) return false;
  return std::abs(*before.value - *now.value) <= tolerance_;  // no such answer is nan
}

void Baseline::compare(Held& at, std::size_t place, const SaidThere& before,
                       const SaidThere& now) const {
  EngineChange& change = at.change;
  if (before.digest.empty() && now.digest.empty()) return;
  if (before.digest.empty() || now.digest.empty()) {
    ++change.missing;
    return;
  }
  ++change.compared;
  if (before.time > 0) at.ratios.add(now.time / before.time);
  if (is_same(before, now)) return;
  ++change.changed;
  if (change.places.size() < kMostNamed) change.places.push_back(place);
  const bool was_wrong = before.verdict == Verdict::Wrong;
  const bool is_wrong = now.verdict == Verdict::Wrong;
  change.right_to_wrong += before.verdict == Verdict::Right && is_wrong;
  change.wrong_to_right += was_wrong && now.verdict == Verdict::Right;
  change.wrong_to_wrong += was_wrong && is_wrong;
}

void Baseline::add(std::size_t place, std::span<const SaidThere> before,
                   std::span<const SaidThere> now) {
  for (const SaidThere& each : now) {
    const SaidThere* its = find(before, each.engine);
    Held& at = held(each.engine);
    if (its == nullptr) {
      ++at.change.missing;
    } else {
      compare(at, place, *its, each);
    }
  }
  for (const SaidThere& each : before)
    if (find(now, each.engine) == nullptr) ++held(each.engine).change.missing;
}

std::vector<EngineChange> Baseline::changes() const {
  std::vector<EngineChange> all;
  for (const Held& each : engines_) {
    all.push_back(each.change);
    if (each.change.compared > 0 && each.ratios.median() > 0) {
      all.back().time_ratio = each.ratios.median();
    }
  }
  std::stable_partition(all.begin(), all.end(),
                        [](const EngineChange& each) { return each.engine == "graze"; });
  return all;
}

}  // namespace graze::compare
