#pragma once

#include <graze/narrowphase/motion/path_lanes.h>

namespace graze::narrowphase {

/// Says what the rounded stage found.
enum class RoundedContact {
  None,       ///< surely no contact
  Root,       ///< the first contact is the one time in [low, high] at which all are in one plane
  Unsure,     ///< there is no contact before `low`
  OutOfRange  ///< magnitudes are such that something could overflow or underflow
};

struct RoundedAnswer {
  RoundedContact kind;
  double low = 0;
  double high = 1;
};

/// Asks the rounded stage, for coordinates that are finite. Contacts later than `until` may be left
/// out.
RoundedAnswer rounded_contact(const PathLanes& lanes, PathPair kind, double until = 1);

/// Returns the largest double that is not above the only root of the volume in [low, high], at
/// which its signs differ; nothing if rounded arithmetic of twice the precision cannot tell.
std::optional<double> root_rounded_down(const PathLanes& lanes, PathPair kind,
                                        const RoundedAnswer& answer);

/// Returns the same exactly.
double root_rounded_down_exactly(const FourPaths& paths, const RoundedAnswer& answer);

}  // namespace graze::narrowphase
