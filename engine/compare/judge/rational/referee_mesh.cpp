#include <graze/engine/compare/judge/rational/referee_mesh.h>

#include <algorithm>
#include <mutex>
#include <vector>

namespace graze::compare {
namespace {

/// So many meshes are kept however large they are, both of two pairs that take turns: a mesh of a
/// million triangles takes some 250 MB here. More are kept, as those of a scene, while all together
/// have no more than so many triangles.
constexpr std::size_t kKeptOfAnySize = 4;
constexpr std::size_t kMostTriangles = std::size_t{1} << 17;

/// Smaller ones are made again sooner than they are looked for.
constexpr std::size_t kWorthKeeping = 64;

std::vector<Triangle> triangles_of(const Mesh& mesh) {
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.triangles().size());
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i)
    triangles.push_back(mesh.triangle(i));
  return triangles;
}

/// Keeps meshes; those that were asked for last come first.
class Shelf {
 public:
  std::shared_ptr<const RefereeMesh> find(const Mesh& mesh) {
    const std::lock_guard lock(mutex_);
    return find_unlocked(mesh);
  }

  /// Adds a mesh. Two threads may have made the same one: both are right, and neither has waited.
  void add(std::shared_ptr<const RefereeMesh> mesh) {
    const std::lock_guard lock(mutex_);
    if (find_unlocked(mesh->mesh())) return;
    kept_.insert(kept_.begin(), std::move(mesh));
    std::size_t triangles = 0;
    for (const auto& each : kept_)
      triangles += each->mesh().triangles().size();
    for (; kept_.size() > kKeptOfAnySize && triangles > kMostTriangles; kept_.pop_back())
      triangles -= kept_.back()->mesh().triangles().size();
  }

 private:
  std::shared_ptr<const RefereeMesh> find_unlocked(const Mesh& mesh) {
    const auto at = std::find_if(kept_.begin(), kept_.end(),
                                 [&](const auto& each) { return each->mesh() == mesh; });
    if (at == kept_.end()) return nullptr;
    std::rotate(kept_.begin(), at, at + 1);
    return kept_.front();
  }

  std::mutex mutex_;
  std::vector<std::shared_ptr<const RefereeMesh>> kept_;
};

}  // namespace

RefereeMesh::RefereeMesh(const Mesh& mesh) : mesh_(mesh), tree_(triangles_of(mesh)) {
  tree_.halve_all();
}

std::shared_ptr<const RefereeMesh> referee_mesh(const Mesh& mesh) {
  if (mesh.triangles().size() < kWorthKeeping) return std::make_shared<RefereeMesh>(mesh);
  static Shelf shelf;
  if (std::shared_ptr<const RefereeMesh> known = shelf.find(mesh)) return known;
  auto made = std::make_shared<const RefereeMesh>(mesh);
  shelf.add(made);
  return made;
}

}  // namespace graze::compare
