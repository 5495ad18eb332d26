#pragma once

#include <graze/engine/world/contact_tracker.h>

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "samples/simulation/rigid_body.h"

namespace graze::samples {

struct SolverSettings {
  double step = 1.0 / 150;  ///< seconds
  double gravity = 9.81;    ///< m/s^2
  double friction = 0.4;    ///< Coulomb's coefficient of things that are no body of the span
  int iterations = 10;
  int relaxations = 4;      ///< iterations on top, which do not push bodies apart
  double slop = 5e-5;       ///< metres that bodies may overlap without being pushed apart
  double push_share = 0.2;  ///< the share of the rest that is pushed apart in a step
  double push_speed = 0.3;  ///< metres a second, at most
  double hertz = 0;         ///< if it is positive, overlaps are pushed apart as by a spring of that
                            ///< frequency
  double damping = 10;  ///< the damper beside that spring, as a multiple of the critical damping
  bool keeps_push =
      false;  ///< true if new contacts start from all that those before pushed and turned
  double wake_speed = 0.25;  ///< metres a second, at which a body that arrives wakes one that
                             ///< sleeps
  double load_share = 0.25;  ///< a share of a sleeping body's weight: the body wakes if a
                             ///< contact that bore more ends
};

/// Solves contacts by sequential impulses (E. Catto, "Iterative Dynamics with Temporal Coherence",
/// 2005). It knows bodies by their World::user_data(), the index in the span of bodies; anything
/// else does not move. Contacts are kept until the world tells of newer ones or of their end, and
/// start from the impulses that they had before (ContactTracker). In between, the depth follows
/// from how far their points have come. Two surfaces rub with the geometric mean of their
/// coefficients.
class ContactSolver {
 public:
  explicit ContactSolver(const SolverSettings& settings) : settings_(settings) {}

  /// The World::user_data() of things that are no body of the span and do not move.
  static constexpr std::uint64_t kFixed = ~0ull;

  /// Lists in `woken` the sleeping bodies that lost a support.
  void take(const World& world, const WorldUpdate& update, std::span<const RigidBody> bodies,
            std::vector<std::size_t>& woken);

  /// Changes velocities so that the contacts of bodies that are awake hold at the step's end; lists
  /// in `woken` the sleeping ones that were hit.
  void solve(std::span<RigidBody> bodies, std::vector<std::size_t>& woken);

  /// Takes out the velocities that only pushed bodies apart, after the positions have followed.
  void relax(std::span<RigidBody> bodies);

  std::size_t pair_count() const { return touches_.size(); }
  std::size_t contact_count() const;

 private:
  struct Point {
    std::uint64_t id = 0;                ///< the contact's number in ContactTracker
    Eigen::Vector3d anchor_a, anchor_b;  ///< points in the frames of the bodies, or of the world
    double depth = 0;                    ///< the depth where the contact was found
    Eigen::Vector3d axis[3];             ///< the normal, from A to B, and two directions across it
    double impulse[3] = {0, 0, 0};
    Eigen::Vector3d arm_a{0, 0, 0},
        arm_b{0, 0, 0};          ///< from the centres of mass, as they are turned now
    double mass[3] = {0, 0, 0};  ///< the mass that an impulse along each axis moves
    double gap = 0;              ///< the gap now; negative where they overlap
  };
  struct Touch {
    std::uint64_t a, b;
    double friction = 0;  ///< the coefficient of the two surfaces on each other
    std::vector<Point> points;
  };

  /// Says how overlaps are pushed apart: at a share of them each second, by impulses of which a
  /// share counts and of which a share of the impulse so far is taken back.
  struct Softness {
    double rate, mass_share, impulse_share;
  };

  /// Adds what the impulses of a pair's contacts lack of the push of those before, or of its
  /// moment.
  static void keep_push(const Pose& pose_a, const std::vector<Point>& before,
                        std::vector<Point>& points);
  double friction_of(std::uint64_t index, std::span<const RigidBody> bodies) const;
  void prepare(Touch& touch, std::span<const RigidBody> bodies) const;
  void start_warm(Touch& touch, std::span<RigidBody> bodies) const;
  void iterate(Touch& touch, std::span<RigidBody> bodies, bool is_pushing) const;
  Softness softness() const;
  void apply(const Touch& touch, const Point& point, int axis, double impulse,
             std::span<RigidBody> bodies) const;

  SolverSettings settings_;
  ContactTracker tracker_;
  std::map<BodyPair, Touch> touches_;
  std::vector<Touch*> active_;
};

}  // namespace graze::samples
