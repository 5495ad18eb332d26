#pragma once

#include <graze/narrowphase/volumes/sphere_arrays.h>
#include <cstdint>
#include <span>

namespace graze {

// These functions make many tests at once, a SIMD width at a time on whatever SIMD the CPU has
// (Ericson, "Real-Time Collision Detection", 2005: four pairs of spheres at once). hits[i] becomes
// 1 or 0, exactly what intersects() answers for element i alone, on every SIMD target. `hits` has
// the length of the arrays, which may be 0, and does not share memory with them. All throw
// InputError for arrays whose lengths differ and for bad volumes, naming the first bad element;
// `hits` is then unspecified.

/// Tests one sphere against each of many.
void intersects(const Sphere& sphere, const SphereArray& spheres, std::span<std::uint8_t> hits);

/// Tests pairs: element i of one array against element i of the other.
void intersects(const SphereArray& spheres_a, const SphereArray& spheres_b,
                std::span<std::uint8_t> hits);

/// Tests one sphere against each of many boxes.
void intersects(const Sphere& sphere, const AabbArray& boxes, std::span<std::uint8_t> hits);

/// Tests one box against each of many spheres.
void intersects(const Aabb& box, const SphereArray& spheres, std::span<std::uint8_t> hits);

/// Tests pairs: sphere i against box i.
void intersects(const SphereArray& spheres, const AabbArray& boxes, std::span<std::uint8_t> hits);

}  // namespace graze
