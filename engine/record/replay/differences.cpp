// Finds where two runs part: list by list, and within a list pair by pair.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/record/coding/work_counters.h>
#include <graze/engine/record/replay_recording.h>

#include <algorithm>
#include <array>
#include <cstdio>

namespace graze {
namespace {

using Difference = std::optional<RecordingDifference>;

std::string hex_of(double number) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.17g", number);
  return text.data();
}

/// Finds the first pair that is in one alone of two ascending lists.
Difference in_lists(std::size_t update, const char* what, const std::vector<BodyPair>& first,
                    const std::vector<BodyPair>& second) {
  const auto [at, other] = std::mismatch(first.begin(), first.end(), second.begin(), second.end());
  if (at == first.end() && other == second.end()) return std::nullopt;
  const bool is_of_first = other == second.end() || (at != first.end() && *at < *other);
  return RecordingDifference{update, what, is_of_first ? *at : *other,
                             is_of_first ? "listed" : "not listed",
                             is_of_first ? "not listed" : "listed"};
}

Difference in_counts(std::size_t update, const char* what, std::uint64_t first,
                     std::uint64_t second) {
  if (first == second) return std::nullopt;
  return RecordingDifference{update, what, std::nullopt, std::to_string(first),
                             std::to_string(second)};
}

std::string brief(const Manifold& manifold) {
  if (manifold.empty()) return "none";
  double deepest = manifold[0].depth;
  for (const ShapeContact& contact : manifold)
    deepest = std::max(deepest, contact.depth);
  return std::to_string(manifold.size()) + " points, deepest " + hex_of(deepest);
}

std::string brief(const BodyContact& contact) {
  return brief(contact.manifold);
}

std::string brief(const BodyFirstContact& met) {
  return std::string(met.contact.status == RigidStatus::Hit ? "hit" : "close") + " from " +
         hex_of(met.contact.low) + " to " + hex_of(met.contact.high);
}

/// Compares lists in ascending order of pairs, where a pair may have several elements.
template <typename Element>
Difference in_elements(std::size_t update, const char* what, const std::vector<Element>& first,
                       const std::vector<Element>& second) {
  const auto [at, other] = std::mismatch(first.begin(), first.end(), second.begin(), second.end());
  if (at == first.end() && other == second.end()) return std::nullopt;
  if (other == second.end() || (at != first.end() && at->pair < other->pair))
    return RecordingDifference{update, what, at->pair, brief(*at), "not listed"};
  if (at == first.end() || other->pair < at->pair)
    return RecordingDifference{update, what, other->pair, "not listed", brief(*other)};
  RecordingDifference both{update, what, at->pair, brief(*at), brief(*other)};
  if (both.first == both.second) both.second += ", but other numbers";
  return both;
}

Difference in_work(std::size_t update, const RecordedAnswers& first,
                   const RecordedAnswers& second) {
  if (!first.work || !second.work) return std::nullopt;
  std::vector<std::uint64_t> counters;
  record::for_each_counter(
      *second.work, [&](const char*, std::uint64_t counter) { counters.push_back(counter); });
  Difference difference;
  std::size_t at = 0;
  record::for_each_counter(*first.work, [&](const char* name, std::uint64_t counter) {
    const std::uint64_t other = counters[at++];
    if (difference || counter == other) return;
    difference = in_counts(update, (std::string("work, ") + name).c_str(), counter, other);
  });
  return difference;
}

/// Says what a change is, and whether two of one kind are equal.
struct ChangeWords {
  std::string operator()(const BodyAdded& change) const {
    return of("added", change.id) + " with shape " + std::to_string(change.shape);
  }
  std::string operator()(const BodyRemoved& change) const { return of("removed", change.id); }
  std::string operator()(const BodyMoved& change) const { return of("moved", change.id); }
  std::string operator()(const BodyTaken& change) const { return of("moved", change.id); }
  std::string operator()(const BodyReshaped& change) const { return of("reshaped", change.id); }
  std::string operator()(const BodySet& change) const { return of("set", change.id); }
  std::string operator()(const BodySlept& change) const {
    return of(change.is_awake ? "woken" : "put to sleep", change.id);
  }
  std::string operator()(const PairExcluded& change) const {
    return of(change.is_excluded ? "excluded" : "included", change.a);
  }
  std::string operator()(const PairFilterSet&) const { return "filter set"; }
  std::string operator()(const BodyNamed& change) const { return of("named", change.id); }
  std::string operator()(const WorldRestored&) const { return "restored"; }

 private:
  static std::string of(const char* what, BodyId id) {
    return std::string(what) + ": body " + std::to_string(id.index);
  }
};

struct ChangeEquality {
  bool operator()(const BodyAdded& s, const BodyAdded& t) const {
    return s.id == t.id && s.shape == t.shape && are_equal(s.pose, t.pose) &&
           s.settings == t.settings;
  }
  bool operator()(const BodyRemoved& s, const BodyRemoved& t) const { return s.id == t.id; }
  bool operator()(const BodyMoved& s, const BodyMoved& t) const {
    return s.id == t.id && are_equal(s.pose, t.pose);
  }
  bool operator()(const BodyTaken& s, const BodyTaken& t) const {
    return s.id == t.id && s.motion == t.motion;
  }
  bool operator()(const BodyReshaped& s, const BodyReshaped& t) const {
    return s.id == t.id && s.shape == t.shape;
  }
  bool operator()(const BodySet& s, const BodySet& t) const {
    return s.id == t.id && s.what == t.what && s.settings == t.settings;
  }
  bool operator()(const BodySlept& s, const BodySlept& t) const {
    return s.id == t.id && s.is_awake == t.is_awake;
  }
  bool operator()(const PairExcluded& s, const PairExcluded& t) const {
    return s.a == t.a && s.b == t.b && s.is_excluded == t.is_excluded;
  }
  bool operator()(const PairFilterSet& s, const PairFilterSet& t) const {
    return s.is_set == t.is_set;
  }
  bool operator()(const BodyNamed& s, const BodyNamed& t) const {
    return s.id == t.id && s.name == t.name;
  }
  bool operator()(const WorldRestored& s, const WorldRestored& t) const {
    return s.state->touching == t.state->touching &&
           std::equal(s.state->bodies.begin(), s.state->bodies.end(), t.state->bodies.begin(),
                      t.state->bodies.end(), [](const RecordedBody& a, const RecordedBody& b) {
                        return a.id == b.id && a.shape == b.shape && are_equal(a.pose, b.pose) &&
                               a.settings == b.settings && a.is_awake == b.is_awake;
                      });
  }
  template <typename S, typename T>
  bool operator()(const S&, const T&) const {
    return false;
  }
};

std::string brief(const RecordedChange& change) {
  return std::visit(ChangeWords{}, change);
}

}  // namespace

Difference first_difference(std::size_t update, const RecordedAnswers& first,
                            const RecordedAnswers& second) {
  return bvh::in_standard_arithmetic([&]() -> Difference {
    Difference found = in_lists(update, "begun", first.begun, second.begun);
    if (!found) found = in_lists(update, "ended", first.ended, second.ended);
    if (!found) found = in_lists(update, "begun near", first.begun_near, second.begun_near);
    if (!found) found = in_lists(update, "ended near", first.ended_near, second.ended_near);
    if (!found)
      found = in_elements(update, "first contacts", first.first_contacts, second.first_contacts);
    if (!found) found = in_elements(update, "contacts", first.contacts, second.contacts);
    if (!found) found = in_counts(update, "pairs that moved", first.moved, second.moved);
    if (!found) found = in_counts(update, "manifolds", first.all_contacts, second.all_contacts);
    if (!found) found = in_work(update, first, second);
    return found;
  });
}

Difference first_difference(std::size_t update, const std::vector<RecordedChange>& first,
                            const std::vector<RecordedChange>& second) {
  return bvh::in_standard_arithmetic([&]() -> Difference {
    const std::size_t both = std::min(first.size(), second.size());
    for (std::size_t i = 0; i < both; ++i) {
      if (std::visit(ChangeEquality{}, first[i], second[i])) continue;
      RecordingDifference difference{update, "change " + std::to_string(i), std::nullopt,
                                     brief(first[i]), brief(second[i])};
      if (difference.first == difference.second) difference.second += ", but otherwise";
      return difference;
    }
    if (first.size() == second.size()) return std::nullopt;
    const bool is_of_first = first.size() > both;
    const std::string more = brief((is_of_first ? first : second)[both]);
    return RecordingDifference{update, "change " + std::to_string(both), std::nullopt,
                               is_of_first ? more : "none", is_of_first ? "none" : more};
  });
}

}  // namespace graze
