#include <graze/engine/mesh/io/ply_rows.h>
#include <cmath>
#include <string>

namespace graze::mesh_io {
namespace {

constexpr std::string_view kValue = "a value";

std::uint64_t shortest_row(const PlyElement& element) {
  std::uint64_t bytes = 0;
  for (const PlyProperty& property : element.properties) {
    bytes += size_of(property.count_type.value_or(property.type));
  }
  return bytes;
}

}  // namespace

void PlyAsciiRows::begin_row(const PlyElement& element, std::uint64_t row) {
  if (cursor_.find_token()) return;
  cursor_.fail("the file ends after " + std::to_string(row) + " of " +
               std::to_string(element.count) + " rows of element " + quoted(element.name));
}

void PlyAsciiRows::skip(PlyType, std::uint64_t count) {
  for (; count > 0; --count) {
    if (!cursor_.has_token()) cursor_.fail("expected a number, but the line ends");
    cursor_.token();
  }
}

std::uint64_t PlyAsciiRows::max_rows(const PlyElement& element) const {
  // Each value takes a digit and a blank, or the line's end.
  return cursor_.remaining() / (2 * element.properties.size()) + 1;
}

void PlyAsciiRows::finish() {
  while (cursor_.find_token()) {
    const std::string_view token = cursor_.token();
    if (token != "comment") cursor_.fail("unexpected " + quoted(token) + " after the last row");
    cursor_.skip_line();
  }
}

void PlyBinaryRows::begin_element(const PlyElement& element) {
  if (element.count <= max_rows(element)) return;
  cursor_.fail(std::to_string(element.count) + " rows of element " + quoted(element.name) +
               " need at least " + std::to_string(shortest_row(element)) + " bytes each, but " +
               std::to_string(cursor_.remaining()) + " follow");
}

std::uint64_t PlyBinaryRows::max_rows(const PlyElement& element) const {
  return cursor_.remaining() / shortest_row(element);
}

double PlyBinaryRows::number(PlyType type) {
  const Place place = cursor_.place();
  double value = 0;
  if (type == PlyType::Float64) {
    value = cursor_.read<double>(kValue);
  } else if (type == PlyType::Float32) {
    value = cursor_.read<float>(kValue);
  } else {
    value = static_cast<double>(integer(type));  // the type has at most 32 bits: this is exact
  }
  if (!std::isfinite(value)) cursor_.fail_at(place, "a coordinate is not finite");
  return value;
}

std::int64_t PlyBinaryRows::integer(PlyType type) {
  switch (type) {
    case PlyType::Int8:
      return cursor_.read<std::int8_t>(kValue);
    case PlyType::Uint8:
      return cursor_.read<std::uint8_t>(kValue);
    case PlyType::Int16:
      return cursor_.read<std::int16_t>(kValue);
    case PlyType::Uint16:
      return cursor_.read<std::uint16_t>(kValue);
    case PlyType::Int32:
      return cursor_.read<std::int32_t>(kValue);
    case PlyType::Uint32:
      return cursor_.read<std::uint32_t>(kValue);
    case PlyType::Float32:
    case PlyType::Float64:
      break;
  }
  cursor_.fail("the header gives a whole number a floating-point type");
}

void PlyBinaryRows::skip(PlyType type, std::uint64_t count) {
  cursor_.skip(count * size_of(type), count == 1 ? kValue : "a list");
}

void PlyBinaryRows::finish() {
  if (cursor_.remaining() == 0) return;
  cursor_.fail(std::to_string(cursor_.remaining()) + " bytes follow the last row");
}

}  // namespace graze::mesh_io
