#pragma once

#include "samples/simulation/rigid_body.h"

namespace graze::samples {

/// Moves a body by its velocity and its spin for so many seconds.
void advance(RigidBody& body, double seconds);

/// Changes the spin of a body without torque, whose inertia turns with it: one Newton step of the
/// implicit Euler rule, which takes energy and adds none (Catto, "Numerical Methods", 2015).
void precess(RigidBody& body, double seconds);

}  // namespace graze::samples
