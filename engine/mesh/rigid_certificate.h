#pragma once

#include <graze/engine/mesh/rigid_contact.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace graze {

/// One step of a proof. A proof is about all triangles of both meshes from t = 0 to 1 at first;
/// each step either proves what it is about, or divides it in two, of which the next steps are
/// about the first, and what follows them about the second.
struct FreedomStep {
  /// The kinds of steps.
  enum class Kind : std::uint8_t {
    Plane,      ///< planes across `normal` keep the parts of both apart all the time
    HalveTime,  ///< the next steps are about the earlier half, then the later
    DivideA,    ///< they are about the first `count` triangles of A, then the rest
    DivideB     ///< they are about the first `count` triangles of B, then the rest
  };
  Kind kind;               ///< what the step does
  std::uint32_t count;     ///< the number of triangles for DivideA and DivideB, else 0
  Eigen::Vector3d normal;  ///< the normal for Plane, from A to B, of any length, else 0

  bool operator==(const FreedomStep&) const = default;
};

/// A proof that two meshes in rigid motion stay further apart than a clearance: it is plain
/// numbers, which can be kept, sent and checked by whoever trusts no function of graze but
/// proves_freedom().
struct FreedomCertificate {
  double clearance;                    ///< metres, that which is proved
  std::vector<std::uint32_t> order_a;  ///< A's triangles, each once: parts are stretches of this
  std::vector<std::uint32_t> order_b;  ///< B's triangles, likewise
  std::vector<FreedomStep> steps;      ///< the steps, in the order above

  bool operator==(const FreedomCertificate&) const = default;
};

/// Returns a proof where is_free() says yes, and nothing where it says no. It takes 40 bytes a
/// step, of which there are up to two for each pair of boxes or triangles that is tested.
std::optional<FreedomCertificate> certify_free(const MeshInMotion& mesh_a,
                                               const MeshInMotion& mesh_b,
                                               const RigidContactSettings& settings = {},
                                               Work* work = nullptr);

/// True if a certificate proves that these meshes in these motions stay further apart than its
/// clearance for every real t from 0 to 1, placed by law 1 in the poses of the motions or in real
/// arithmetic. It looks at no tree and at nothing that is computed elsewhere: one function in
/// interval arithmetic (rigid/freedom_check.cpp). Whatever it accepts is so, whoever made it; any
/// certificate may be refused, but of those that certify_free() makes only the ones for motions of
/// many thousand turns, or for triangles ten thousand million times as large as the tolerance. What
/// is broken in any way is refused with false; nothing is thrown for it.
bool proves_freedom(const FreedomCertificate& certificate, const MeshInMotion& mesh_a,
                    const MeshInMotion& mesh_b);

}  // namespace graze
