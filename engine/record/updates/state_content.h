#pragma once

#include <graze/engine/record/coding/byte_reader.h>
#include <graze/engine/record/coding/byte_writer.h>
#include <graze/engine/record/recording.h>
#include <graze/engine/world/bodies/world_state.h>

#include <functional>
#include <memory>
#include <span>

namespace graze::record {

/// The settings of a body that is there.
BodySettings settings_of(const Bodies::Body& body);

/// What each shape of the world has as its number.
using NumberOfBodyShape = std::function<std::uint32_t(const std::shared_ptr<const BodyShape>&)>;

/// All of a world that a snapshot has: ids, bodies, exclusions, and which pairs touch.
void write_state(const WorldContents& contents, const NumberOfBodyShape& number_of, ByteWriter& to);

/// `filter` is what a filter of the user's own is from there on. Throws RecordingError for what no
/// world can be.
RecordedState read_state(ByteReader& from, std::span<const std::shared_ptr<const BodyShape>> shapes,
                         const std::function<bool(BodyId, BodyId)>& filter);

/// Throws unless a world could hold the body: what Bodies that are restored are not asked.
void check_body(const BodyShape& shape, const Pose& pose, const BodySettings& settings);

}  // namespace graze::record
