#pragma once

#include <graze/engine/record/coding/byte_reader.h>
#include <graze/engine/record/coding/byte_writer.h>
#include <graze/engine/record/recording.h>
#include <graze/engine/world/bodies/world_state.h>

#include <functional>
#include <memory>
#include <span>

namespace graze::record {

/// Returns the settings of a body that is there.
BodySettings settings_of(const Bodies::Body& body);

/// Returns the number that a shape of the world has.
using NumberOfBodyShape = std::function<std::uint32_t(const std::shared_ptr<const BodyShape>&)>;

/// Writes all of a world that a snapshot has: ids, bodies, exclusions, and which pairs touch.
void write_state(const WorldContents& contents, const NumberOfBodyShape& number_of, ByteWriter& to);

/// Reads a state; `filter` is what a user's own filter is from there on. Throws RecordingError for
/// what no world can be.
RecordedState read_state(ByteReader& from, std::span<const std::shared_ptr<const BodyShape>> shapes,
                         const std::function<bool(BodyId, BodyId)>& filter);

/// Throws unless a world could hold the body, as Bodies that are restored are not asked.
void check_body(const BodyShape& shape, const Pose& pose, const BodySettings& settings);

}  // namespace graze::record
