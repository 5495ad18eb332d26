#pragma once

#include <graze/narrowphase/cast.h>
#include <graze/narrowphase/first_contact.h>

#include <cstddef>

namespace graze::narrowphase {

// These functions refuse, by InputError, what first contacts cannot be asked about: coordinates
// that are not finite, naming the thing, its number unless that is kNoNumber, and the vertex; and
// settings that are none.

inline constexpr std::size_t kNoNumber = static_cast<std::size_t>(-1);

void check_paths(const PointPath& point, const TrianglePath& triangle,
                 std::size_t number = kNoNumber);
void check_paths(const EdgePath& edge_a, const EdgePath& edge_b, std::size_t number = kNoNumber);
void check_paths(const TrianglePath& triangle_a, const TrianglePath& triangle_b,
                 std::size_t number = kNoNumber);

void check_settings(const FirstContactSettings& settings);
void check_settings(const CastSettings& settings);

/// Throws InputError for lengths that differ.
void check_lengths(std::size_t length_a, std::size_t length_b, std::size_t contacts);

}  // namespace graze::narrowphase
