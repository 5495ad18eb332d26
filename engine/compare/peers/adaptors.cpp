#include <graze/engine/compare/peers/adaptors.h>
#include <graze/engine/compare/peers/known_peers.h>

namespace graze::compare {

std::unique_ptr<Engine> make_adaptor(const std::string& name) {
#if GRAZE_HAS_FCL
  if (name == "fcl") return make_fcl_engine();
  if (name == "fcl-advancement") return make_fcl_advancement_engine();
#endif
#if GRAZE_HAS_BULLET
  if (name == "bullet") return make_bullet_engine();
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
  for (const KnownPeer& peer : kKnownPeers) {
    if (!peer.is_here) continue;
    names += names.empty() ? "" : ", ";
    names += peer.name;
  }
  return names.empty() ? "none, as this was built" : names;
}

}  // namespace graze::compare
