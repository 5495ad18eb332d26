#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/element_error.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/pose_batch.h>
#include <graze/engine/mesh/query/batch.h>
#include <graze/engine/mesh/query/threads.h>

namespace graze {
namespace {

/// The most poses of a part: enough that far ones, of a hundred nanoseconds each, outweigh its
/// start.
constexpr std::size_t kMostInAPart = 64;

void check_poses(const PlacedMeshView& a, const MeshInPoses& b) {
  check_placement(a.pose, a.mesh.bounds(), "pose of mesh A");
  for (std::size_t i = 0; i < b.poses.size(); ++i) {
    bvh::check_element("pose", i, " of mesh B", [&](const char* what) {
      check_placement(b.poses[i], b.mesh.bounds(), what);
    });
  }
}

/// Fills `answers`, one for each pose, by `ask(placed B, work)`.
template <typename Answer, typename Ask>
void answer_all(const PlacedMeshView& a, const MeshInPoses& b, const BatchSettings& batch,
                Work* total, std::vector<Answer>& answers, Ask&& ask) {
  check_threads(batch.threads);
  check_poses(a, b);
  answers.resize(b.poses.size());
  for_each_in_batch(b.poses.size(), kMostInAPart, batch, total, [&](std::size_t i, Work& work) {
    answers[i] = ask(PlacedMeshView{b.mesh, b.poses[i]}, work);
  });
}

/// Does the same for answers of yes and no: many threads cannot write to the bits of one word.
template <typename Ask>
std::vector<bool> say_all(const PlacedMeshView& a, const MeshInPoses& b, const BatchSettings& batch,
                          Work* total, const Ask& ask) {
  std::vector<char> answers;
  answer_all(a, b, batch, total, answers, [&](const PlacedMeshView& placed_b, Work& work) {
    return static_cast<char>(ask(placed_b, work));
  });
  return {answers.begin(), answers.end()};
}

}  // namespace

std::vector<bool> intersects(const PlacedMeshView& mesh_a, const MeshInPoses& mesh_b,
                             const QuerySettings& settings, const BatchSettings& batch,
                             Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<bool> {
    return say_all(mesh_a, mesh_b, batch, work, [&](const PlacedMeshView& b, Work& own) {
      return intersects(mesh_a, b, settings, &own);
    });
  });
}

std::vector<bool> interiors_intersect(const PlacedMeshView& mesh_a, const MeshInPoses& mesh_b,
                                      const BatchSettings& batch, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<bool> {
    return say_all(mesh_a, mesh_b, batch, work, [&](const PlacedMeshView& b, Work& own) {
      return interiors_intersect(mesh_a, b, &own);
    });
  });
}

std::vector<bool> within(const PlacedMeshView& mesh_a, const MeshInPoses& mesh_b, double clearance,
                         const DistanceSettings& settings, const BatchSettings& batch, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<bool> {
    return say_all(mesh_a, mesh_b, batch, work, [&](const PlacedMeshView& b, Work& own) {
      return within(mesh_a, b, clearance, settings, &own);
    });
  });
}

std::vector<TrianglePairs> find_triangle_pairs(const PlacedMeshView& mesh_a,
                                               const MeshInPoses& mesh_b,
                                               const PairSettings& settings,
                                               const BatchSettings& batch, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<TrianglePairs> {
    std::vector<TrianglePairs> answers;
    answer_all(mesh_a, mesh_b, batch, work, answers, [&](const PlacedMeshView& b, Work& own) {
      return find_triangle_pairs(mesh_a, b, settings, &own);
    });
    return answers;
  });
}

std::vector<MeshDistance> distance(const PlacedMeshView& mesh_a, const MeshInPoses& mesh_b,
                                   const DistanceSettings& settings, const BatchSettings& batch,
                                   Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<MeshDistance> {
    std::vector<MeshDistance> answers;
    answer_all(mesh_a, mesh_b, batch, work, answers, [&](const PlacedMeshView& b, Work& own) {
      return distance(mesh_a, b, settings, &own);
    });
    return answers;
  });
}

}  // namespace graze
