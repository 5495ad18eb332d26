#pragma once

#include <string>

#include <graze/engine/view/writing/view_data.h>

namespace graze::view {

/// Returns the bytes that a page unpacks: README.md has their format.
std::string packed_view(const ShownView& view);

}  // namespace graze::view
