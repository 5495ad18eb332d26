#pragma once

#include <array>

// Lists which engines there are besides graze, and whether they were found when this was built.
// Private to engine/compare/peers, whose CMakeLists.txt says it.

#ifndef GRAZE_HAS_FCL
#define GRAZE_HAS_FCL 0
#endif
#ifndef GRAZE_HAS_BULLET
#define GRAZE_HAS_BULLET 0
#endif
#ifndef GRAZE_HAS_ODE
#define GRAZE_HAS_ODE 0
#endif
#ifndef GRAZE_HAS_COAL
#define GRAZE_HAS_COAL 0
#endif

namespace graze::compare {

struct KnownPeer {
  const char* name;
  bool is_here;
};

inline constexpr std::array<KnownPeer, 5> kKnownPeers = {{{"fcl", GRAZE_HAS_FCL != 0},
                                                          {"bullet", GRAZE_HAS_BULLET != 0},
                                                          {"ode", GRAZE_HAS_ODE != 0},
                                                          {"coal", GRAZE_HAS_COAL != 0},
                                                          {"fcl-advancement", GRAZE_HAS_FCL != 0}}};

/// These know motions alone, with settings that hardly anybody chooses: they take part where they
/// are named.
inline constexpr std::array<KnownPeer, 13> kMotionPeers = {
    {{"fcl-1000", GRAZE_HAS_FCL != 0},
     {"fcl-swapped", GRAZE_HAS_FCL != 0},
     {"fcl-translation", GRAZE_HAS_FCL != 0},
     {"fcl-screw", GRAZE_HAS_FCL != 0},
     {"fcl-spline", GRAZE_HAS_FCL != 0},
     {"fcl-polynomial", GRAZE_HAS_FCL != 0},
     {"fcl-advancement-swapped", GRAZE_HAS_FCL != 0},
     {"fcl-advancement-indep", GRAZE_HAS_FCL != 0},
     {"fcl-advancement-fine", GRAZE_HAS_FCL != 0},
     {"fcl-advancement-translation", GRAZE_HAS_FCL != 0},
     {"fcl-advancement-screw", GRAZE_HAS_FCL != 0},
     {"bullet-subsimplex", GRAZE_HAS_BULLET != 0},
     {"bullet-gjk", GRAZE_HAS_BULLET != 0}}};

/// These are asked about all pairs of a scene at once, and about nothing else unless they are
/// named.
inline constexpr std::array<KnownPeer, 7> kScenePeers = {{{"fcl-tree", GRAZE_HAS_FCL != 0},
                                                          {"fcl-tree-array", GRAZE_HAS_FCL != 0},
                                                          {"fcl-sap", GRAZE_HAS_FCL != 0},
                                                          {"fcl-ssap", GRAZE_HAS_FCL != 0},
                                                          {"fcl-interval", GRAZE_HAS_FCL != 0},
                                                          {"fcl-hash", GRAZE_HAS_FCL != 0},
                                                          {"fcl-naive", GRAZE_HAS_FCL != 0}}};

}  // namespace graze::compare
