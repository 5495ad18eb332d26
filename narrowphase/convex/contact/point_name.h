#pragma once

#include <graze/narrowphase/convex/contact/contact_points.h>

namespace graze::narrowphase {

/// Names the one point in which two sets meet and which is on no corner, edge or face in
/// particular. On a round side it is named by the part of the side that looks along the normal, so
/// that another way out has another name. Where sides are sharp beside the depth, as at tips and
/// about one axis, the way out turns with the least motion, and parts are narrower than a degree.
void name_point(const Core& a, const Core& b, ContactPoint& contact);

}  // namespace graze::narrowphase
