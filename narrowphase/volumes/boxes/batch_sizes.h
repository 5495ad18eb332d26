#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace graze::narrowphase {

/// Throws InputError unless there is one element of `hits` for each pair.
void check_hits(std::span<const std::uint8_t> hits, std::size_t pairs);

/// Throws InputError, which names the volumes by `what`, unless both lists have one size.
void check_pairs(std::size_t size_a, std::size_t size_b, const char* what);

}  // namespace graze::narrowphase
