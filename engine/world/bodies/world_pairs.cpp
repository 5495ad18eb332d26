// Lists bodies, and the pairs of all of them or of one that touched or were near at the last
// update.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/world/bodies/world_state.h>

#include <algorithm>

namespace graze {

std::vector<BodyId> World::bodies(const BodyQuerySettings& settings) const {
  const State& state = *state_;
  std::vector<BodyId> bodies;
  for (std::uint32_t index = 0; index < state.all.bodies.size(); ++index) {
    if (state.all.ids.is_live(index) && state.is_asked_for(index, settings))
      bodies.push_back(state.all.id(index));
  }
  return bodies;
}

std::vector<BodyPair> World::State::list_pairs(PairState state) const {
  std::vector<BodyPair> pairs;
  for (std::uint32_t at = 0; at < candidates.list().size(); ++at) {
    const BoxPair pair = candidates.list()[at];
    if (candidates.is(at, state) && all.ids.is_live(pair.a) && all.ids.is_live(pair.b))
      pairs.push_back(all.id_pair(pair));
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Returns the pairs of one body. Unless changes wait for an update, boxes are still those from
/// which the pairs were found.
std::vector<BodyPair> World::State::list_pairs_of(std::uint32_t index, PairState state) const {
  std::vector<BodyPair> pairs;
  const auto add = [&](std::uint32_t at) {
    const BoxPair pair = candidates.list()[at];
    if (candidates.is(at, state) && all.ids.is_live(pair.a) && all.ids.is_live(pair.b))
      pairs.push_back(all.id_pair(pair));
  };
  if (is_updated()) {
    for_candidates_of(index, add);
  } else {
    for (std::uint32_t at = 0; at < candidates.list().size(); ++at) {
      const BoxPair pair = candidates.list()[at];
      if (pair.a == index || pair.b == index) add(at);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<BodyPair> World::pairs() const {
  return state_->list_pairs(PairState::Touching);
}

std::vector<BodyPair> World::near_pairs() const {
  return state_->list_pairs(PairState::Near);
}

std::vector<BodyPair> World::pairs(BodyId id) const {
  const State& state = *state_;
  state.body(id, "pairs");
  return state.list_pairs_of(id.index, PairState::Touching);
}

std::vector<BodyPair> World::near_pairs(BodyId id) const {
  const State& state = *state_;
  state.body(id, "near_pairs");
  return state.list_pairs_of(id.index, PairState::Near);
}

std::vector<BodyId> World::touching(BodyId id) const {
  const State& state = *state_;
  state.body(id, "touching");
  std::vector<BodyId> bodies;
  for (const BodyPair& pair : state.list_pairs_of(id.index, PairState::Touching))
    bodies.push_back(pair.a == id ? pair.b : pair.a);
  return bodies;
}

}  // namespace graze
