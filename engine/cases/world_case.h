#pragma once

// Makes cases of what a world says of its bodies. They are about the bodies' shapes where the
// bodies are now, so they have to be made before one of them is moved again. A world asks no more
// than the queries of shapes do, so that these answer the case. All throw StaleIdError for a body
// that is gone, and UnsupportedPairError for a shape of a user's own, which no file can hold, and
// for a compound where no part of it is named. Where one is named, the case is about that part
// alone.

#include <graze/engine/cases/to_case.h>
#include <graze/engine/world/world.h>

namespace graze {

/// Returns a body as one of the two shapes of a case.
CaseBody case_body(const World& world, BodyId id);

/// Makes a case of whether two bodies touch, for a pair in `begun`, `moved`, `ended` or pairs().
Case to_case(const World& world, const BodyPair& pair, bool touches);

/// Makes a case of one of `contacts` or contacts().
Case to_case(const World& world, const BodyContact& contact);

/// Make cases of whether a body is among find_touching(), and of what find_within() and
/// find_closest() found: A is the shape that was asked about.
Case to_case(const World& world, const CaseBody& asked, BodyId body, bool touches);
Case to_case(const World& world, const CaseBody& asked, const BodyDistance& found);

/// Makes a case of one of the bodies that cast_ray() and cast_ray_all() found.
Case to_case(const World& world, const Ray& ray, const BodyRayHit& found);

}  // namespace graze
