#include <graze/engine/files/sha256.h>
#include <graze/engine/record/shapes/shape_content.h>
#include <graze/engine/record/write/shape_table.h>

namespace graze::record {

std::uint32_t ShapeTable::number_of(const std::shared_ptr<const BodyShape>& shape) {
  const auto known = by_handle_.find(shape);
  if (known != by_handle_.end()) return known->second;
  ByteWriter content;
  const auto number_of_part = [this](const Shape& part) {
    ByteWriter of_part;
    write_shape(part, of_part);
    return number_of_content(of_part);
  };
  write_body_shape(*shape, number_of_part, content);
  const std::uint32_t number = number_of_content(content);
  by_handle_.emplace(shape, number);
  return number;
}

std::uint32_t ShapeTable::number_of_content(const ByteWriter& content) {
  const auto next = static_cast<std::uint32_t>(by_digest_.size());
  const auto [known, is_new] = by_digest_.try_emplace(files::sha256_of(content.view()), next);
  if (is_new) on_shape_(content.view());
  return known->second;
}

}  // namespace graze::record
