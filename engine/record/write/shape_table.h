#pragma once

#include <graze/engine/record/coding/byte_writer.h>
#include <graze/engine/world/body.h>
#include <graze/engine/world/shape.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>

namespace graze::record {

/// Keeps the numbers that shapes have in a recording: each content once. It knows equal shapes by
/// the SHA-256 of their bytes.
class ShapeTable {
 public:
  /// Calls `on_shape(content)` for each new shape, in the order of their numbers.
  explicit ShapeTable(std::function<void(std::string_view)> on_shape)
      : on_shape_(std::move(on_shape)) {}

  /// Returns the number of a shape. Throws InputError for a shape of a user's own.
  std::uint32_t number_of(const std::shared_ptr<const BodyShape>& shape);

 private:
  std::uint32_t number_of_content(const ByteWriter& content);

  std::function<void(std::string_view)> on_shape_;
  /// Shapes are kept by handle, and not by their address, which another shape may have later. A
  /// shape that nobody else holds is gone all the same.
  std::map<std::weak_ptr<const BodyShape>, std::uint32_t, std::owner_less<>> by_handle_;
  std::unordered_map<std::string, std::uint32_t> by_digest_;
};

}  // namespace graze::record
