#include <graze/engine/compare/peers/adaptors.h>
#include <graze/engine/compare/peers/known_peers.h>

#include <algorithm>

namespace graze::compare {

std::unique_ptr<Engine> make_adaptor(const std::string& name) {
#if GRAZE_HAS_FCL
  if (name == "fcl") return make_fcl_engine();
  if (std::unique_ptr<Engine> engine = make_fcl_motion_engine(name)) return engine;
  if (std::unique_ptr<Engine> manager = make_fcl_manager_engine(name)) return manager;
#endif
#if GRAZE_HAS_BULLET
  if (name == "bullet") return make_bullet_engine();
  if (std::unique_ptr<Engine> casts = make_bullet_cast_engine(name)) return casts;
#endif
#if GRAZE_HAS_ODE
  if (name == "ode") return make_ode_engine();
#endif
#if GRAZE_HAS_COAL
  if (name == "coal") return make_coal_engine();
#endif
  return nullptr;
}

std::string adaptor_names() {
  std::string names;
  const auto add = [&](const KnownPeer& peer) {
    if (!peer.is_here) return;
    names += names.empty() ? "" : ", ";
    names += peer.name;
  };
  std::for_each(kKnownPeers.begin(), kKnownPeers.end(), add);
  std::for_each(kMotionPeers.begin(), kMotionPeers.end(), add);
  std::for_each(kScenePeers.begin(), kScenePeers.end(), add);
  return names.empty() ? "none, as this was built" : names;
}

}  // namespace graze::compare
