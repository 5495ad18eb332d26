#pragma once

// This is private to engine/mesh/rigid.

#include <graze/engine/mesh/rigid/contact_walk.h>
#include <graze/engine/mesh/rigid/motion_checks.h>
#include <graze/engine/mesh/rigid/moving_pair.h>
#include <graze/engine/mesh/rigid_contact.h>

namespace graze {

/// The bodies and their pair, with which all questions about two motions begin.
struct MotionQuery {
  MovingBody a;
  MovingBody b;
  MovingPair pair;
  const RigidContactSettings& settings;
  Work& work;

  /// Throws InputError for settings that are not valid, PoseError for motions that lead too far
  /// away.
  MotionQuery(const MeshInMotion& mesh_a, const MeshInMotion& mesh_b,
              const RigidContactSettings& of_settings, Work& of_work)
      : a(mesh_a.mesh, mesh_a.motion, "motion of mesh A", of_work),
        b(mesh_b.mesh, mesh_b.motion, "motion of mesh B", of_work),
        pair(a, b, check_settings(of_settings)),
        settings(of_settings),
        work(of_work) {}

  ContactWalk walk(ContactWalk::End end) { return {pair, end, settings.budget, work}; }
};

}  // namespace graze
