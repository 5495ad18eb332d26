#pragma once

#include <graze/bvh/aabb.h>
#include <graze/narrowphase/lanes/aabb_rows.h>
#include <graze/narrowphase/lanes/triangle_rows.h>
#include <graze/narrowphase/lanes/verdicts.h>
#include <graze/narrowphase/triangle.h>

namespace graze::narrowphase {

// These functions find what triage() says of each pair of triangle and box by the thirteen axes,
// for many at once, on whatever SIMD the CPU has. verdicts[i] becomes those of elements 8 i to 8 i
// + 7. Pairs that are left unsure go to decide(). The verdicts are the same on every SIMD target.

/// Tests one triangle against each of many boxes.
void triage(const Triangle& triangle, const AabbRows& many, Verdicts* verdicts);

/// Tests one box against each of many triangles.
void triage(const Aabb& box, const TriangleRows& many, Verdicts* verdicts);

/// Tests pairs: element i of one against element i of the other, which is as long.
void triage(const TriangleRows& triangles, const AabbRows& boxes, Verdicts* verdicts);

}  // namespace graze::narrowphase
