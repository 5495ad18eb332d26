#pragma once

#include <vector>

#include "samples/simulation/scenes/judgement.h"
#include "samples/simulation/scenes/scene.h"

namespace graze::samples {

/// Returns a ball of 0.5 m that rolls 100 m along x over a plane without slipping, in 4 s or, if it
/// is large, in 40 s. It must roll on a plane of triangles whose corners lie at random as it does
/// on the flat side of a box.
Scene rolling_ball(Surface ground, Extent extent = Extent::Small);

/// Says what a ball did that rolls along x.
struct Roll {
  double distance = 0;  ///< metres along x
  double aside = 0;     ///< metres away from the line, the most
  double height = 0;    ///< metres, the most that its centre rose or sank from where it began
  double slower = 0;    ///< the share of the speed that it lost in the end; negative if it gained
  double unrolled = 0;  ///< the share of the speed by which its lowest point slips in the end
};

/// Runs the scene; its last body is the ball.
Roll roll(const Scene& scene);

/// Returns a wheel of 0.3 m, of so many sectors if it is a mesh, that rolls at 3 m/s over a kerb of
/// 2 cm.
Scene wheel_over_kerb(Surface surface, Extent extent = Extent::Small);

/// Returns the speed that the wheel has beyond the kerb, m/s, if it loses no energy but in the one
/// impact at which it begins to turn about the edge, without slipping.
double speed_beyond_kerb();

}  // namespace graze::samples
