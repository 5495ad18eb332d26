#pragma once

#include <graze/engine/world/world.h>

#include <cstdint>
#include <map>
#include <string>

#include "tests/engine/histories/oracle.h"

namespace graze::tests {

/// Throws std::runtime_error unless it is true.
void expect(bool is_true, const std::string& what);

/// Puts the question to the world and to every body that the oracle knows, one by one; throws
/// std::runtime_error where they differ, in the last bit. Returns how many bodies answer it.
std::size_t check_answer(const Operation& question, const World& world, const Oracle& oracle,
                         const std::map<BodyId, std::uint32_t>& names);

/// Throws likewise unless islands() are those of a search through all pairs that touch.
void check_islands(const World& world);

}  // namespace graze::tests
