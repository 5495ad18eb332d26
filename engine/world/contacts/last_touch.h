#pragma once

// Finds where a convex body touches another one last on its way out. Private to engine/world.

#include <graze/narrowphase/convex/core/core.h>

#include <optional>

namespace graze {

/// The way that a body has gone when it touches another one for the last time, and where it does.
struct LastTouch {
  double way;                  ///< metres, from where the body is
  narrowphase::Vec3 on_body;   ///< a point of the body's surface, where the body is
  narrowphase::Vec3 on_other;  ///< the point of the other one that it meets
};

/// A way out of a body.
struct WayOut {
  narrowphase::Vec3 direction;  ///< unit
  double length;                ///< metres, after which the two are apart, or just touch
  double least;                 ///< metres, the last touch that is looked for
};

/// Returns the last touch of the body and the other one along the way, or nothing if they do not
/// touch there. The body comes back from the end of the way by Newton's method: each step goes as
/// far as the two are apart along the plane between them, so that none goes too far but for what a
/// gap is off by.
std::optional<LastTouch> last_touch(const narrowphase::Core& body, const narrowphase::Core& other,
                                    const WayOut& out);

}  // namespace graze
