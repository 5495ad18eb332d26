#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/element_error.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/pose_batch.h>
#include <graze/engine/mesh/query/threads.h>

#include <algorithm>
#include <mutex>
#include <string>

namespace graze {
namespace {

/// Poses of a part: enough that far ones, of a hundred nanoseconds each, outweigh its start.
constexpr std::size_t kMostInAPart = 64;

/// Parts for each thread, at least, where there are poses enough.
constexpr std::size_t kPartsPerThread = 16;

void check_poses(const PlacedMeshView& a, const MeshInPoses& b) {
  check_placement(a.pose, a.mesh.bounds(), "pose of mesh A");
  for (std::size_t i = 0; i < b.poses.size(); ++i) {
    bvh::at_element("pose", i, [&] {
      check_placement(b.poses[i], b.mesh.bounds(),
                      ("pose " + std::to_string(i) + " of mesh B").c_str());
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
  const std::size_t parts = thread_count(batch.threads) * kPartsPerThread;
  const std::size_t size = std::clamp(b.poses.size() / parts, std::size_t{1}, kMostInAPart);
  std::mutex mutex;
  for_each_part((b.poses.size() + size - 1) / size, batch.threads, [&](std::size_t part) {
    Work work;
    const std::size_t end = std::min((part + 1) * size, b.poses.size());
    for (std::size_t i = part * size; i < end; ++i)
      answers[i] = ask(PlacedMeshView{b.mesh, b.poses[i]}, work);
    const std::scoped_lock lock(mutex);
    if (total != nullptr) *total += work;
  });
}

}  // namespace

std::vector<bool> intersects(const PlacedMeshView& mesh_a, const MeshInPoses& mesh_b,
                             const QuerySettings& settings, const BatchSettings& batch,
                             Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<bool> {
    // Bits of one word are no place for many threads to write to.
    std::vector<char> answers;
    answer_all(mesh_a, mesh_b, batch, work, answers, [&](const PlacedMeshView& b, Work& own) {
      return static_cast<char>(intersects(mesh_a, b, settings, &own));
    });
    return {answers.begin(), answers.end()};
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
