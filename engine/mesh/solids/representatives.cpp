#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/data/vertex_fans.h>
#include <graze/engine/mesh/solids/representatives.h>

namespace graze {

// A set of untouched triangles either shares a vertex with a touched one, or is a component.
std::set<std::uint32_t> Representatives::untouched(
    const std::function<bool(std::uint32_t)>& is_wanted) {
  std::set<std::uint32_t> found;
  for (const std::uint32_t index : touched_) {
    for (const std::uint32_t vertex : mesh_.triangles()[index])
      add_near(vertex, is_wanted, found);
  }
  for (const std::uint32_t vertex : mesh_.component_vertices())
    add_near(vertex, is_wanted, found);
  return found;
}

std::set<std::uint32_t> Representatives::connected(
    std::uint32_t index, const std::function<bool(std::uint32_t)>& is_wanted) const {
  const VertexFans& fans = vertex_fans_of(mesh_);
  std::set<std::uint32_t> found;
  std::unordered_set<std::uint32_t> seen;
  std::vector<std::uint32_t> open{index};
  while (!open.empty()) {
    const std::uint32_t next = open.back();
    open.pop_back();
    if (is_wanted(next)) found.insert(next);
    for (const std::uint32_t corner : mesh_.triangles()[next]) {
      if (!seen.insert(mesh_.welded()[corner]).second) continue;
      for (const std::uint32_t other : fans.around(mesh_.welded()[corner])) {
        if (!touched_.contains(other)) open.push_back(other);
      }
    }
  }
  return found;
}

void Representatives::add_near(std::uint32_t vertex,
                               const std::function<bool(std::uint32_t)>& is_wanted,
                               std::set<std::uint32_t>& found) {
  const VertexFans& fans = vertex_fans_of(mesh_);
  std::vector<std::uint32_t> open{mesh_.welded()[vertex]};
  while (!open.empty()) {
    const std::uint32_t next = open.back();
    open.pop_back();
    if (!seen_.insert(next).second) continue;
    for (const std::uint32_t index : fans.around(next)) {
      if (touched_.contains(index)) continue;
      if (is_wanted(index)) {
        found.insert(index);
        return;
      }
      for (const std::uint32_t corner : mesh_.triangles()[index])
        open.push_back(mesh_.welded()[corner]);
    }
  }
}

}  // namespace graze
