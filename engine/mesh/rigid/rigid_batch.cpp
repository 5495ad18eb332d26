#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/element_error.h>
#include <graze/engine/mesh/query/batch.h>
#include <graze/engine/mesh/query/threads.h>
#include <graze/engine/mesh/rigid/motion_checks.h>
#include <graze/engine/mesh/rigid_contact.h>

#include <string>

namespace graze {
namespace {

/// Fills `answers` by `ask(i, work)`. Motions differ a thousandfold in what they take, so that each
/// is a part by itself.
template <typename Answer, typename Ask>
void answer_all(const BatchSettings& batch, Work* total, std::vector<Answer>& answers,
                const Ask& ask) {
  for_each_in_batch(answers.size(), 1, batch, total,
                    [&](std::size_t i, Work& work) { answers[i] = ask(i, work); });
}

/// Returns one answer for each motion of B.
template <typename Answer, typename Ask>
std::vector<Answer> answers_of_motions(const MeshInMotions& mesh_b, const BatchSettings& batch,
                                       Work* total, const Ask& ask) {
  check_threads(batch.threads);
  for (std::size_t i = 0; i < mesh_b.motions.size(); ++i) {
    bvh::check_element("motion", i, " of mesh B", [&](const char* what) {
      check_coordinates(mesh_b.motions[i], mesh_b.mesh.bounds(), what);
    });
  }
  std::vector<Answer> answers(mesh_b.motions.size());
  answer_all(batch, total, answers,
             [&](std::size_t i, Work& work) { return ask(mesh_b.motions[i], work); });
  return answers;
}

/// Returns one answer for each pair.
template <typename Answer, typename Ask>
std::vector<Answer> answers_of_pairs(std::span<const RigidPair> pairs,
                                     const RigidContactSettings& settings,
                                     const BatchSettings& batch, Work* total, const Ask& ask) {
  check_settings(settings);
  check_threads(batch.threads);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    bvh::at_element("pair", i, [&] {
      const std::string of_pair = " of pair " + std::to_string(i);
      const RigidPair& pair = pairs[i];
      check_coordinates(pair.a.motion, pair.a.mesh.bounds(),
                        ("motion of mesh A" + of_pair).c_str());
      check_coordinates(pair.b.motion, pair.b.mesh.bounds(),
                        ("motion of mesh B" + of_pair).c_str());
    });
  }
  std::vector<Answer> answers(pairs.size());
  answer_all(batch, total, answers, [&](std::size_t i, Work& work) { return ask(pairs[i], work); });
  return answers;
}

}  // namespace

std::vector<RigidContact> first_contact(const MeshInMotion& mesh_a, const MeshInMotions& mesh_b,
                                        const RigidContactSettings& settings,
                                        const BatchSettings& batch, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<RigidContact> {
    return answers_of_motions<RigidContact>(
        mesh_b, batch, work, [&](const RigidMotion& b, Work& own) {
          return first_contact(mesh_a, {mesh_b.mesh, b}, settings, &own);
        });
  });
}

std::vector<bool> is_free(const MeshInMotion& mesh_a, const MeshInMotions& mesh_b,
                          const RigidContactSettings& settings, const BatchSettings& batch,
                          Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<bool> {
    // There is a char for each answer, because many threads cannot write to the bits of one word.
    const std::vector<char> answers =
        answers_of_motions<char>(mesh_b, batch, work, [&](const RigidMotion& b, Work& own) {
          return static_cast<char>(is_free(mesh_a, {mesh_b.mesh, b}, settings, &own));
        });
    return {answers.begin(), answers.end()};
  });
}

std::vector<RigidContact> first_contact(std::span<const RigidPair> pairs,
                                        const RigidContactSettings& settings,
                                        const BatchSettings& batch, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<RigidContact> {
    return answers_of_pairs<RigidContact>(pairs, settings, batch, work,
                                          [&](const RigidPair& pair, Work& own) {
                                            return first_contact(pair.a, pair.b, settings, &own);
                                          });
  });
}

std::vector<bool> is_free(std::span<const RigidPair> pairs, const RigidContactSettings& settings,
                          const BatchSettings& batch, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<bool> {
    const std::vector<char> answers =
        answers_of_pairs<char>(pairs, settings, batch, work, [&](const RigidPair& pair, Work& own) {
          return static_cast<char>(is_free(pair.a, pair.b, settings, &own));
        });
    return {answers.begin(), answers.end()};
  });
}

}  // namespace graze
