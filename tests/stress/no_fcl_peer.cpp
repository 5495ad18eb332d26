#include "tests/stress/fcl_peer.h"

namespace graze::stress {

std::unique_ptr<Peer> make_fcl_peer(const Mesh&, const Mesh&) {
  return nullptr;
}

}  // namespace graze::stress
