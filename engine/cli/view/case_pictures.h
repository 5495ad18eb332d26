#pragma once

#include <cstddef>

#include <graze/engine/cli/replay/case_list.h>
#include <graze/engine/cli/view/shown_pair.h>

namespace graze::cli {

/// The number of pictures along a motion, its two ends included.
inline constexpr std::size_t kMotionPictures = 49;

/// True if something moves in a case.
bool has_course(const Case& query);

/// Adds a picture of a case to a page, or kMotionPictures of one that moves. Throws what its
/// queries and the page throw.
void show_case(const ListedCase& listed, ShownPage& page);

}  // namespace graze::cli
