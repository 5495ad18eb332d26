#pragma once

// What a world says of its bodies, as cases about their shapes where the bodies are now: to be made
// before one of them is moved again. A world asks no more than the queries of shapes do, so that
// these answer the case. All throw StaleIdError for a body that is gone, and UnsupportedPairError
// for a shape of a user's own, which no file can hold, and for a compound where no part of it is
// named: of a part they are about it alone.

#include <graze/engine/cases/to_case.h>
#include <graze/engine/world/world.h>

namespace graze {

/// A body as one of the two shapes of a case.
CaseBody case_body(const World& world, BodyId id);

/// Whether two bodies touch: of a pair in `begun`, `moved`, `ended` or pairs().
Case to_case(const World& world, const BodyPair& pair, bool touches);

/// One of `contacts` or contacts().
Case to_case(const World& world, const BodyContact& contact);

/// Whether a body is among find_touching(), and what find_within() and find_closest() found: A is
/// the shape that was asked about.
Case to_case(const World& world, const CaseBody& asked, BodyId body, bool touches);
Case to_case(const World& world, const CaseBody& asked, const BodyDistance& found);

/// One of the bodies that cast_ray() and cast_ray_all() found.
Case to_case(const World& world, const Ray& ray, const BodyRayHit& found);

}  // namespace graze
