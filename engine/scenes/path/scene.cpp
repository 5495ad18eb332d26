#include <graze/engine/scenes/scene.h>

#include <set>

namespace graze {

std::shared_ptr<const BodyShape> body_shape(const Scene& scene, const SceneBody& body) {
  if (body.parts.empty()) return share(scene.shapes[body.shape].shape);
  Compound compound;
  for (const ScenePart& part : body.parts)
    compound.add({scene.shapes[part.shape].shape, part.pose}, part.settings);
  return share(compound);
}

std::vector<ScenePair> meeting_pairs(const Scene& scene) {
  const std::set<ScenePair> excluded(scene.exclusions.begin(), scene.exclusions.end());
  std::vector<ScenePair> pairs;
  for (std::size_t a = 0; a < scene.bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < scene.bodies.size(); ++b) {
      const SceneBody& body_a = scene.bodies[a];
      const SceneBody& body_b = scene.bodies[b];
      if (body_a.kind != BodyKind::Dynamic && body_b.kind != BodyKind::Dynamic) continue;
      if (!lets_pass(body_a.filter, body_b.filter) || excluded.contains({a, b})) continue;
      pairs.push_back({a, b});
    }
  }
  return pairs;
}

}  // namespace graze
