#pragma once

#include <memory>
#include <string>

#include <graze/engine/compare/peers/engine.h>

namespace graze::compare {

// These functions make engines as graze-peer holds them. Most of them have globals, or keep state
// in what they have loaded: one thread of one process may ask, about one load at a time.

std::unique_ptr<Engine> make_fcl_engine();
/// Makes FCL with other settings for motions than its own, of that name; null if there is none.
std::unique_ptr<Engine> make_fcl_motion_engine(const std::string& name);
/// Makes FCL's manager of that name; null if there is none.
std::unique_ptr<Engine> make_fcl_manager_engine(const std::string& name);
std::unique_ptr<Engine> make_bullet_engine();
/// Makes Bullet's casts of that name, which know motions alone; null if there are none.
std::unique_ptr<Engine> make_bullet_cast_engine(const std::string& name);
std::unique_ptr<Engine> make_ode_engine();
std::unique_ptr<Engine> make_coal_engine();

/// Makes the adaptor of that name; null if this was built without it.
std::unique_ptr<Engine> make_adaptor(const std::string& name);

/// Returns the names of the adaptors that it was built with: "fcl, ode".
std::string adaptor_names();

}  // namespace graze::compare
