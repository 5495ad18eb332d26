#include <graze/engine/world/shape_ray.h>
#include <graze/engine/world/world.h>

#include <optional>

#include "tests/benchmark/height_fields/contestant.h"

namespace graze::benchmark {

namespace {

/// A world whose ground is the field, or the field's mesh.
class Graze : public FieldContestant {
 public:
  void place(const Terrain& terrain) override {
    world_.emplace();
    world_->add({*ground_}, {.kind = BodyKind::Static});
    ids_.clear();
    for (std::size_t i = 0; i < terrain.bodies.size(); ++i)
      ids_.push_back(
          world_->add({terrain.bodies[i], terrain.frames[0][i]}, {.filter = {.group = -1}}));
    world_->update();
  }
  std::size_t step(const std::vector<Pose>& frame) override {
    world_->move(ids_, frame);
    return world_->update().contacts.size();
  }
  std::size_t cast(std::span<const Ray> rays) override {
    std::size_t hits = 0;
    for (const Ray& ray : rays)
      hits += cast_ray({*ground_}, ray).has_value();
    return hits;
  }

 protected:
  static HeightField field_of(const Terrain& terrain) {
    return HeightField(terrain.side, terrain.side, std::span<const float>(terrain.heights));
  }
  std::optional<Shape> ground_;

 private:
  std::optional<World> world_;
  std::vector<BodyId> ids_;
};

class GrazeField final : public Graze {
 public:
  std::string name() const override { return "field"; }
  std::size_t build(const Terrain& terrain) override {
    const HeightField field = field_of(terrain);
    ground_.emplace(field);
    return field.bytes();
  }
};

class GrazeMesh final : public Graze {
 public:
  std::string name() const override { return "mesh"; }
  std::size_t build(const Terrain& terrain) override {
    const Mesh mesh = field_of(terrain).mesh();
    ground_.emplace(mesh);
    cast_ray({*ground_}, Ray{{0, 0, 100}, {0, 0, -1}});  // its trees are built
    return mesh.vertices().size_bytes() + mesh.triangles().size_bytes();
  }
};

}  // namespace

std::unique_ptr<FieldContestant> make_graze_field() {
  return std::make_unique<GrazeField>();
}

std::unique_ptr<FieldContestant> make_graze_mesh() {
  return std::make_unique<GrazeMesh>();
}

}  // namespace graze::benchmark
