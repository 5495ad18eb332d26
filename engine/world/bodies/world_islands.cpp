// Keeps the islands up to date with what an update finds: which pairs begin and end, and which
// bodies are new.

#include <graze/engine/world/bodies/world_state.h>

#include <algorithm>
#include <string>

namespace graze {

/// Lists the changed bodies that are to join islands or to leave them.
void World::State::note_island_changes() {
  if (!settings.islands) return;
  island_changes.clear();
  for (const std::uint32_t index : changed) {
    if (all.bodies[index].joins_islands() != islands.has(index)) island_changes.push_back(index);
  }
}

/// Lists the new edges between bodies in islands, each once: the pairs that began to touch, and all
/// pairs that touch of the bodies that join islands.
void World::State::list_island_edges() {
  island_edges.clear();
  const auto add = [&](BoxPair pair) {
    if (all.bodies[pair.a].joins_islands() && all.bodies[pair.b].joins_islands())
      island_edges.push_back(pair);
  };
  for (const BodyPair& pair : news.begun)
    add({pair.a.index, pair.b.index});
  for (const std::uint32_t index : island_changes) {
    if (!all.bodies[index].joins_islands()) continue;
    for_candidates_of(index, [&](std::uint32_t at) {
      const BoxPair pair = candidates.list()[at];
      const std::uint32_t other = pair.a == index ? pair.b : pair.a;
      const bool is_others = other < index && !islands.has(other);
      if (!candidates.touches(at) || is_others) return;
      if (!std::binary_search(news.begun.begin(), news.begun.end(), all.id_pair(pair))) add(pair);
    });
  }
}

/// Brings the islands up to date. To be called when all pairs that began and ended are known. If
/// this throws, the next update finds the same changes again; making a change twice does no harm.
void World::State::keep_up_islands() {
  if (!settings.islands) return;
  list_island_edges();
  islands.make_room(all.bodies.size(), island_edges.size());
  const auto joins = [&](std::uint32_t index) { return all.bodies[index].joins_islands(); };
  for (const std::uint32_t index : island_changes) {
    if (joins(index)) islands.add(index);
  }
  // Edges are added first, so that fewer islands are split and joined again.
  for (const BoxPair& pair : island_edges)
    islands.connect(pair.a, pair.b);
  for (const BodyPair& pair : news.ended) {
    if (islands.has(pair.a.index) && islands.has(pair.b.index))
      islands.disconnect(pair.a.index, pair.b.index);
  }
  for (const std::uint32_t index : island_changes) {
    if (!joins(index)) islands.remove(index);
  }
  // Their indices are not in use again yet: they rest until an update has listed the pairs that
  // ended.
  for (const std::uint32_t index : left_islands) {
    if (islands.has(index)) islands.remove(index);
  }
  left_islands.clear();
  const IslandWork work = islands.take_work();
  news.work.islands_merged = work.merged;
  news.work.islands_split = work.split;
  news.work.island_steps = work.steps;
}

/// Builds the islands of a world that has just been restored, whose state is that after an update.
void World::State::rebuild_islands() {
  if (!settings.islands) return;
  left_islands.clear();
  island_changes.clear();
  for (std::uint32_t index = 0; index < all.bodies.size(); ++index) {
    if (all.ids.is_live(index) && all.bodies[index].joins_islands())
      island_changes.push_back(index);
  }
  keep_up_islands();
}

void World::State::check_islands(const char* what) const {
  if (settings.islands) return;
  throw InputError(std::string(what) +
                   ": the world keeps none, as WorldSettings::islands is false");
}

/// Returns the bodies of an island, ascending, without bodies that were removed since the last
/// update.
std::vector<BodyId> World::State::island_of(std::uint32_t index) const {
  std::vector<std::uint32_t> indices;
  islands.list(index, indices);
  std::sort(indices.begin(), indices.end());
  std::vector<BodyId> bodies;
  for (const std::uint32_t each : indices) {
    if (all.ids.is_live(each)) bodies.push_back(all.id(each));
  }
  return bodies;
}

std::vector<BodyId> World::island(BodyId id) const {
  const State& state = *state_;
  state.body(id, "island");
  state.check_islands("island");
  if (!state.islands.has(id.index)) return {};
  return state.island_of(id.index);
}

std::vector<std::vector<BodyId>> World::islands() const {
  const State& state = *state_;
  state.check_islands("islands");
  std::vector<std::vector<BodyId>> islands;
  std::vector<bool> is_listed(state.all.bodies.size(), false);
  for (std::uint32_t index = 0; index < is_listed.size(); ++index) {
    if (!state.all.ids.is_live(index) || !state.islands.has(index) || is_listed[index]) continue;
    islands.push_back(state.island_of(index));
    for (const BodyId body : islands.back())
      is_listed[body.index] = true;
  }
  return islands;
}

}  // namespace graze
