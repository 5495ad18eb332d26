#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/element_error.h>
#include <graze/engine/mesh/query/threads.h>
#include <graze/engine/mesh/rigid/motion_checks.h>
#include <graze/engine/mesh/rigid_contact.h>

#include <mutex>
#include <string>

namespace graze {
namespace {

/// Fills `answers`, one for each motion, by `ask(motion of B, work)`. Motions differ a thousandfold
/// in what they take, so that each is a part by itself.
template <typename Answer, typename Ask>
void answer_all(const Mesh& mesh_b, std::span<const RigidMotion> motions_b,
                const BatchSettings& batch, Work* total, std::vector<Answer>& answers,
                const Ask& ask) {
  check_threads(batch.threads);
  for (std::size_t i = 0; i < motions_b.size(); ++i) {
    bvh::at_element("motion", i, [&] {
      check_reach(motions_b[i], mesh_b.bounds(),
                  ("motion " + std::to_string(i) + " of mesh B").c_str());
    });
  }
  answers.resize(motions_b.size());
  std::mutex mutex;
  for_each_part(motions_b.size(), batch.threads, [&](std::size_t i) {
    Work work;
    answers[i] = ask(motions_b[i], work);
    const std::scoped_lock lock(mutex);
    if (total != nullptr) *total += work;
  });
}

}  // namespace

std::vector<RigidContact> first_contact(const Mesh& mesh_a, const RigidMotion& motion_a,
                                        const Mesh& mesh_b, std::span<const RigidMotion> motions_b,
                                        const RigidContactSettings& settings,
                                        const BatchSettings& batch, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<RigidContact> {
    std::vector<RigidContact> answers;
    answer_all(mesh_b, motions_b, batch, work, answers, [&](const RigidMotion& b, Work& own) {
      return first_contact(mesh_a, motion_a, mesh_b, b, settings, &own);
    });
    return answers;
  });
}

std::vector<bool> is_free(const Mesh& mesh_a, const RigidMotion& motion_a, const Mesh& mesh_b,
                          std::span<const RigidMotion> motions_b,
                          const RigidContactSettings& settings, const BatchSettings& batch,
                          Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<bool> {
    // Bits of one word are no place for many threads to write to.
    std::vector<char> answers;
    answer_all(mesh_b, motions_b, batch, work, answers, [&](const RigidMotion& b, Work& own) {
      return static_cast<char>(is_free(mesh_a, motion_a, mesh_b, b, settings, &own));
    });
    return {answers.begin(), answers.end()};
  });
}

}  // namespace graze
