#include <graze/engine/cli/compare/wrong_list.h>

#include <algorithm>

namespace graze::cli {
namespace {

using compare::WrongAnswer;
using Numbered = std::pair<std::size_t, WrongAnswer>;

/// True if the first is worse; of two that are as bad the one that came first counts.
bool is_before(const Numbered& a, const Numbered& b) {
  if (is_worse(a.second, b.second)) return true;
  return !is_worse(b.second, a.second) && a.first < b.first;
}

}  // namespace

WrongList::WrongList(std::size_t keep, FailOn fail_on, std::set<std::string> have_cases)
    : keep_(keep), fail_on_(std::move(fail_on)), have_cases_(std::move(have_cases)) {}

void WrongList::add(WrongAnswer wrong) {
  const std::string& engine = wrong.answer->engine;
  const compare::Judgement& judgement = wrong.answer->judgement;
  const bool is_named = fail_on_.matches(engine, judgement);
  named_ += is_named;
  if (is_named || engine == "graze" || engine == "world") {
    Closing& closing = closing_[engine];
    ++closing.count;
    ++closing.classes[static_cast<std::size_t>(judgement.error_class)];
    if (closing.first.size() < kFirstOfEngine) closing.first.push_back(wrong);
  }
  std::vector<WrongAnswer>& examples = examples_[{engine, judgement.error_class}];
  if (examples.size() < kFirstOfClass) examples.push_back(wrong);
  const std::size_t number = count_++;
  keep_if_worst(number, wrong);
  if (number < kFirst) first_.emplace(number, std::move(wrong));
}

void WrongList::keep_if_worst(std::size_t number, const WrongAnswer& wrong) {
  if (keep_ == 0 || !have_cases_.contains(wrong.answer->engine)) return;
  worst_.emplace_back(number, wrong);
  std::push_heap(worst_.begin(), worst_.end(), is_before);
  if (worst_.size() <= keep_) return;
  std::pop_heap(worst_.begin(), worst_.end(), is_before);
  worst_.pop_back();
}

std::vector<WrongAnswer> WrongList::kept() const {
  std::map<std::size_t, WrongAnswer> all = first_;
  for (const auto& [number, wrong] : worst_)
    all.emplace(number, wrong);
  std::vector<WrongAnswer> list;
  list.reserve(all.size());
  for (auto& [number, wrong] : all)
    list.push_back(std::move(wrong));
  return list;
}

std::span<const WrongAnswer> WrongList::examples(const std::string& engine,
                                                 compare::ErrorClass error_class) const {
  const auto at = examples_.find({engine, error_class});
  if (at == examples_.end()) return {};
  return at->second;
}

const WrongList::Closing& WrongList::closing(const std::string& engine) const {
  static const Closing kNone;
  const auto at = closing_.find(engine);
  return at == closing_.end() ? kNone : at->second;
}

}  // namespace graze::cli
