#pragma once

#include <span>

#include <nlohmann/json.hpp>

#include <graze/engine/view/packing/word_arrays.h>
#include <graze/engine/view/writing/frame_places.h>
#include <graze/engine/view/writing/view_data.h>

namespace graze::view {

/// Returns the member "marks" of a page: what is drawn beside bodies, with its numbers in `arrays`.
/// `shapes` are the frames of the numbers of meshes.
nlohmann::ordered_json packed_marks(const ShownView& view, const FramePlaces& places,
                                    std::span<const NumberFrame> shapes, WordArrays& arrays);

}  // namespace graze::view
