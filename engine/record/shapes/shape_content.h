#pragma once

#include <graze/engine/record/coding/byte_reader.h>
#include <graze/engine/record/coding/byte_writer.h>
#include <graze/engine/world/body.h>
#include <graze/engine/world/shape.h>

#include <cstdint>
#include <functional>
#include <memory>

namespace graze::record {

/// These kinds come on top of ShapeKind, in the byte that begins a shape.
inline constexpr std::uint8_t kCompoundKind = 32, kVoxelMapKind = 33;

/// True if a shape can be written: a user's own cannot.
bool can_be_written(const BodyShape& shape);

/// Returns the number of a part's shape.
using NumberOfShape = std::function<std::uint32_t(const Shape&)>;
/// Returns the shape of a number, which is a Shape, or nullptr.
using ShapeOfNumber = std::function<const Shape*(std::uint32_t)>;

/// Write and read all that a body's shape is: its kind and its numbers. Parts refer to shapes that
/// were written before. Throws InputError for a shape of a user's own.
void write_body_shape(const BodyShape& shape, const NumberOfShape& number_of, ByteWriter& to);
std::shared_ptr<const BodyShape> read_body_shape(ByteReader& from, const ShapeOfNumber& shape_of);

/// Write and read a shape that is no compound and no map of voxels.
void write_shape(const Shape& shape, ByteWriter& to);
Shape read_shape(std::uint8_t kind, ByteReader& from);

}  // namespace graze::record
