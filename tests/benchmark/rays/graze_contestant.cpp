#include <graze/engine/mesh/mesh_ray.h>

#include <optional>

#include "tests/benchmark/rays/contestant.h"

namespace graze::benchmark {
namespace {

class Graze : public RayContestant {
 public:
  Graze() : RayContestant("graze") {}

  void build(const Mesh& mesh) override {
    mesh_ = mesh;
    static_cast<void>(cast_ray({*mesh_}, {{0, 0, 0}, {0, 0, 1}}));
  }

  void take(std::span<const Ray> rays) override { rays_.assign(rays.begin(), rays.end()); }

  std::size_t ask(Question question) override {
    std::size_t hits = 0;
    if (question == Question::First) {
      for (const Ray& ray : rays_)
        hits += cast_ray({*mesh_}, ray).has_value();
    } else if (question == Question::Any) {
      for (const Ray& ray : rays_)
        hits += intersects({*mesh_}, ray);
    } else {
      cast_rays({*mesh_}, rays_, hits_);
      for (const auto& hit : hits_)
        hits += hit.has_value();
    }
    return hits;
  }

 private:
  std::optional<Mesh> mesh_;
  std::vector<Ray> rays_;
  std::vector<std::optional<RayHit>> hits_;
};

}  // namespace

std::unique_ptr<RayContestant> make_graze() {
  return std::make_unique<Graze>();
}

}  // namespace graze::benchmark
