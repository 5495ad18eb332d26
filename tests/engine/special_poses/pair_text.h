#pragma once

// Pairs as text: a line for each shape, its kind and its numbers, and after it a line "at" and the
// three rows of its pose. All numbers to the last bit. A mesh is that of a box, by its half
// extents.

#include <istream>
#include <optional>
#include <string>

#include "tests/engine/special_poses/least_width.h"

namespace graze::tests {

std::string text_of(const PlacedPair& pair);

/// The next pair, or nothing at the end. Lines that are empty or begin with # are passed over.
/// Throws InputError where a line says no such thing.
std::optional<PlacedPair> read_pair(std::istream& text);

}  // namespace graze::tests
