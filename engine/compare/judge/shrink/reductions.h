#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace graze::compare {

using Indices = std::vector<std::uint32_t>;

/// Returns 0, 1, ... below the count.
Indices all_indices(std::size_t count);

/// Takes elements away, by halves, then by quarters, and so on (Zeller and Hildebrandt,
/// "Simplifying and isolating failure-inducing input", IEEE Transactions on Software Engineering
/// 28(2), 2002), while what is left is still enough; at least one stays. Returns whether any could
/// go.
bool take_away(Indices& indices, const std::function<bool(const Indices&)>& still_does);

/// Offers shorter numbers in the place of this one, finite ones, the shortest first, until one will
/// do.
void shorten(double value, const std::function<bool(double)>& will_do);

}  // namespace graze::compare
