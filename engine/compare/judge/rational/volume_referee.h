#pragma once

#include <graze/engine/cases/case.h>

#include <optional>

namespace graze::compare {

/// Whether a placed triangle and a closed volume share a point, exactly (law 3 for oriented boxes,
/// whose frame the triangle is placed into with its rounding).
bool referee_meets(const Triangle& triangle, const Aabb& box);
bool referee_meets(const Triangle& triangle, const Obb& box);
bool referee_meets(const Triangle& triangle, const Sphere& sphere);

/// Whether two volumes do; nothing where the library promises no exact answer (law 11).
std::optional<bool> referee_overlaps(const CaseShape& shape_a, const CaseShape& shape_b);

}  // namespace graze::compare
