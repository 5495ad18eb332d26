// This finds what a ray meets of a placed mesh: triangles that the walk does not surely miss are
// placed, and decided exactly.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/rays/ray_tree_walk.h>
#include <graze/engine/mesh/data/mesh_data.h>
#include <graze/engine/mesh/data/mesh_rays.h>
#include <graze/engine/mesh/mesh_ray.h>
#include <graze/narrowphase/ray/ray_stages.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <algorithm>
#include <limits>

namespace graze {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The answer of on_hit() when it has seen enough.
constexpr double kEnough = -1;

/// Returns the tree for rays, which is made if there is none. Each ray asks: a call takes longer
/// than to see that there is nothing to make.
const MeshRays& made_rays(const Mesh& mesh, Work* work) {
  const auto& data = MeshAccess::data(mesh);
  if (data.are_rays_made.load(std::memory_order_acquire)) [[likely]]
    return *data.rays;
  return rays_of(mesh, work);
}

/// A placed mesh, prepared for any number of rays.
class MeshForRays {
 public:
  MeshForRays(const PlacedMeshView& placed, Work* work)
      : placed_(placed),
        work_(work),
        is_at_rest_(is_identity(placed.pose)),
        rays_(made_rays(placed.mesh, work)),
        frame_(is_at_rest_ ? rays_.at_rest
                           : own_frame_.emplace(ray_frame_of(placed, rays_.tree.frame))),
        vertices_(MeshAccess::data(placed.mesh).vertices.data()),
        triangles_(MeshAccess::data(placed.mesh).triangles) {}

  /// Calls `on_hit(hit, index)` for each placed triangle that the ray meets before a limit, metres,
  /// to which that comes down when it returns one, until it returns kEnough. With RayAim::First it
  /// may leave out hits that are behind another, with RayAim::Any all but one.
  template <typename OnHit>
  void for_each_hit(const Ray& ray, bvh::RayAim aim, OnHit&& on_hit) const {
    const narrowphase::PreparedRay prepared(ray);
    bvh::RayTreeWalk walk;
    Candidates found;
    begin(walk, prepared, aim, vertices_->data(), found);
    finish(walk, prepared, found, on_hit);
  }

  bool is_met(const Ray& ray) const {
    const narrowphase::PreparedRay prepared(ray);
    bvh::RayTreeWalk walk;
    Candidates found;
    begin(walk, prepared, bvh::RayAim::Any, nullptr, found);
    // If there is a sure one, the walk ended with it.
    for (std::size_t i = found.size; i-- > 0;) {
      if (found.items[i].is_sure) return true;
    }
    bool is_met = false;
    finish(walk, prepared, found, [&](const TriangleRayHit&, std::uint32_t) {
      is_met = true;
      return kEnough;
    });
    return is_met;
  }

  RayHit hit_of(const TriangleRayHit& hit, std::uint32_t index) const {
    const auto& materials = MeshAccess::data(placed_.mesh).materials;
    const std::uint16_t material = materials ? (*materials)[index] : std::uint16_t{0};
    return {hit.distance, hit.point, hit.normal, index, material};
  }

  struct Candidates {
    bvh::RayCandidate items[2 * bvh::RayTreeWalk::kAtOnce];
    std::size_t size;
  };

  /// Does the first part of for_each_hit(), which is all that it waits for memory for.
  void begin(bvh::RayTreeWalk& walk, const narrowphase::PreparedRay& ray, bvh::RayAim aim,
             const double* points, Candidates& found) const {
    found.size = walk.begin(rays_.tree,
                            {.frame = frame_,
                             .origin = ray.ray.origin.data(),
                             .direction = ray.scaled.component,
                             .limit = limit_for(ray, ray.ray.max_distance),
                             .aim = aim,
                             .primitives = {triangles_.data(), points}},
                            found.items);
    count(walk.counts());
  }

  /// Does the other part.
  template <typename OnHit>
  void finish(bvh::RayTreeWalk& walk, const narrowphase::PreparedRay& ray, Candidates& found,
              OnHit&& on_hit) const {
    if (walk.is_blind()) [[unlikely]] {
      ask_all(ray, on_hit);
      return;
    }
    for (;;) {
      for (std::size_t i = 0; i < found.size; ++i) {
        const bvh::RayCandidate& candidate = found.items[i];
        if (walk.is_beyond(candidate)) continue;
        const auto hit = cast_at(corners_of(candidate), ray, candidate.is_sure);
        if (!hit) continue;
        const double wanted = on_hit(*hit, candidate.primitive);
        if (wanted == kEnough || (walk.is_done() && i + 1 == found.size)) return;
        if (wanted < kInfinity) walk.limit_to(limit_for(ray, wanted));
      }
      if (walk.is_done()) return;
      found.size = walk.go_on(rays_.tree);
      count(walk.counts());
    }
  }

  /// Returns the points, if their numbers can be had without waiting, or null.
  const double* early_points() const {
    return rays_.tree.leaves == bvh::RayLeaves::SharedPoints ? vertices_->data() : nullptr;
  }

  /// Fetches the corners of the first candidate.
  void prefetch_corners(const Candidates& found) const {
    if (found.size == 0) return;
    for (const std::uint32_t vertex : corners_of(found.items[0]))
      __builtin_prefetch(vertices_ + vertex);
  }

 private:
  /// Returns the parameter before which all is at most that far away, metres.
  double limit_for(const narrowphase::PreparedRay& ray, double distance) const {
    // Most rays have no limit: the walk need not wait for a root and a quotient.
    if (distance == kInfinity) return kInfinity;
    return distance / bvh::length_of(ray.scaled) * frame_.per_metre * (1 + 0x10p-53) + 0x1p-1050;
  }

  void count(const bvh::RayWalkCounts& counts) const {
    if (work_ == nullptr) return;
    work_->volume_tests += counts.boxes;
    work_->volume_rejections += counts.missed_boxes;
    work_->filter_tests += counts.primitives;
  }

  template <typename OnHit>
  void ask_all(const narrowphase::PreparedRay& ray, OnHit&& on_hit) const {
    for (std::uint32_t index = 0; index < triangles_.size(); ++index) {
      const auto hit = cast_at(triangles_[index], ray, false);
      if (hit && on_hit(*hit, index) == kEnough) return;
    }
  }

  /// Returns the candidate's row, from where it is read already.
  const TriangleIndices& corners_of(const bvh::RayCandidate& candidate) const {
    return rays_.tree.leaves == bvh::RayLeaves::SharedPoints ? candidate.corners
                                                             : triangles_[candidate.primitive];
  }

  std::optional<TriangleRayHit> cast_at(const TriangleIndices& corners,
                                        const narrowphase::PreparedRay& ray, bool is_sure) const {
    if (work_ != nullptr) ++work_->triangle_tests;
    if (!is_sure) return cast_at_unsure(corners, ray);
    const auto& [a, b, c] = corners;
    std::optional<TriangleRayHit> found;
    // An identity changes no value but the sign of a zero, which does not show in these.
    if (is_at_rest_) {
      found = narrowphase::cast_through(vertices_[a].data(), vertices_[b].data(),
                                        vertices_[c].data(), ray);
    } else {
      const Triangle triangle = placed(corners);
      found =
          narrowphase::cast_through(triangle.a.data(), triangle.b.data(), triangle.c.data(), ray);
    }
    return found ? found : cast_at_unsure(corners, ray);
  }

  [[gnu::noinline]] std::optional<TriangleRayHit> cast_at_unsure(
      const TriangleIndices& corners, const narrowphase::PreparedRay& ray) const {
    narrowphase::Stage stage;
    auto found = narrowphase::cast_ray(placed(corners), ray, stage);
    if (work_ != nullptr) work_->exact_tests += stage == narrowphase::Stage::Exact;
    return found;
  }

  Triangle placed(const TriangleIndices& corners) const {
    const auto& [a, b, c] = corners;
    return narrowphase::place(placed_.pose, Triangle{vertices_[a], vertices_[b], vertices_[c]});
  }

  const PlacedMeshView& placed_;
  Work* work_;  ///< counters, or null
  bool is_at_rest_;
  const MeshRays& rays_;
  std::optional<bvh::RayFrame> own_frame_;  ///< the frame of a pose that is not the identity
  const bvh::RayFrame& frame_;
  const Eigen::Vector3d* vertices_;
  std::span<const TriangleIndices> triangles_;
};

bool is_before(const RayHit& s, const RayHit& t) {
  if (s.distance != t.distance) return s.distance < t.distance;
  return s.triangle < t.triangle;
}

/// Keeps the first hit.
struct FirstHit {
  const MeshForRays& mesh;
  std::optional<RayHit>& first;

  double operator()(const TriangleRayHit& hit, std::uint32_t index) const {
    if (!first || hit.distance < first->distance ||
        (hit.distance == first->distance && index < first->triangle))
      first = mesh.hit_of(hit, index);
    return first->distance;
  }
};

/// One of several rays whose walks alternate, so that what one waits for comes while another goes.
struct RayInTurn {
  std::optional<narrowphase::PreparedRay> ray;
  bvh::RayTreeWalk walk;
  MeshForRays::Candidates found;
};
constexpr std::size_t kInTurn = 8;

void first_hits(const MeshForRays& mesh, std::span<const Ray> rays, std::optional<RayHit>* hits,
                RayInTurn (&in_turn)[kInTurn]) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    RayInTurn& turn = in_turn[i];
    mesh.begin(turn.walk, turn.ray.emplace(rays[i]), bvh::RayAim::First, mesh.early_points(),
               turn.found);
  }
  for (std::size_t i = 0; i < rays.size(); ++i)
    mesh.prefetch_corners(in_turn[i].found);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    RayInTurn& turn = in_turn[i];
    hits[i].reset();
    mesh.finish(turn.walk, *turn.ray, turn.found, FirstHit{mesh, hits[i]});
  }
}

}  // namespace

std::optional<RayHit> cast_ray(const PlacedMeshView& mesh, const Ray& ray, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::optional<RayHit> {
    check_ray(ray, "ray");
    std::optional<RayHit> first;
    const MeshForRays for_rays(mesh, work);
    for_rays.for_each_hit(ray, bvh::RayAim::First, FirstHit{for_rays, first});
    return first;
  });
}

bool intersects(const PlacedMeshView& mesh, const Ray& ray, Work* work) {
  return bvh::in_standard_arithmetic([&] {
    check_ray(ray, "ray");
    return MeshForRays(mesh, work).is_met(ray);
  });
}

std::vector<RayHit> cast_ray_all(const PlacedMeshView& mesh, const Ray& ray, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<RayHit> {
    check_ray(ray, "ray");
    std::vector<RayHit> hits;
    const MeshForRays for_rays(mesh, work);
    for_rays.for_each_hit(ray, bvh::RayAim::All,
                          [&](const TriangleRayHit& hit, std::uint32_t index) {
                            hits.push_back(for_rays.hit_of(hit, index));
                            return kInfinity;
                          });
    std::sort(hits.begin(), hits.end(), is_before);
    return hits;
  });
}

void cast_rays(const PlacedMeshView& mesh, std::span<const Ray> rays,
               std::vector<std::optional<RayHit>>& hits, Work* work) {
  bvh::in_standard_arithmetic([&] {
    for (const Ray& ray : rays)
      check_ray(ray, "ray");
    const MeshForRays for_rays(mesh, work);
    hits.resize(rays.size());
    RayInTurn in_turn[kInTurn];
    for (std::size_t i = 0; i < rays.size(); i += kInTurn)
      first_hits(for_rays, rays.subspan(i, std::min(kInTurn, rays.size() - i)), hits.data() + i,
                 in_turn);
  });
}

}  // namespace graze
