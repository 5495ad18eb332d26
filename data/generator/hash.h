#pragma once

#include <cstdint>
#include <initializer_list>

namespace graze::generator {

/// Well mixed bits of a list of whole numbers: the same on every machine.
std::uint64_t hash(std::initializer_list<std::int64_t> numbers);

/// The upper 53 bits as a number in [0, 1).
double unit_interval(std::uint64_t bits);

}  // namespace graze::generator
