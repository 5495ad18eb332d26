#pragma once

#include <graze/engine/compare/fcl_motion.h>
#include <graze/engine/compare/peers/engine.h>

namespace graze::compare {

/// Two meshes as FCL holds them for questions about motions.
class FclMotions {
 public:
  FclMotions(const Mesh& mesh_a, const Mesh& mesh_b, FclContinuous how)
      : mover_a_(Shape(mesh_a)), mover_b_(Shape(mesh_b)), how_(how) {}

  /// Of Ask::FirstContact and Free, without a clearance, which FCL does not know here. One time is
  /// all that it says of a contact.
  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const;

 private:
  FclMover mover_a_;
  FclMover mover_b_;
  FclContinuous how_;
};

}  // namespace graze::compare
