#pragma once

#include <graze/bvh/error.h>
#include <graze/engine/cases/text/json_tree.h>
#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace graze::cases {

/// A place in a JSON tree, which knows its own path: errors name the file, the line and
/// the JSON pointer (RFC 6901). It refers to the tree, the file's name and the cursor that it came
/// from, which must outlive it.
class JsonCursor {
 public:
  JsonCursor(const JsonValue& root, const std::string& file) : value_(root), file_(file) {}

  /// Throws CaseError `file:line: /pointer: why`.
  [[noreturn]] void fail(const std::string& why) const;

  /// Throws unless this is an object with keys of this list only.
  void require_keys(std::initializer_list<std::string_view> known) const;

  bool is_null() const { return value_.kind == JsonKind::Null; }
  bool is_object() const { return value_.kind == JsonKind::Object; }
  bool has(std::string_view key) const { return find(key) != nullptr; }
  JsonCursor member(std::string_view key) const;  ///< throws if there is no such member

  std::size_t size() const;  ///< the size of an array; throws for anything else
  void require_size(std::size_t size) const;
  JsonCursor item(std::size_t index) const { return {*this, index}; }

  bool boolean() const;
  const std::string& text() const;
  /// Reads 64 bits from a string, `0x` and up to 16 digits 0-9 a-f: a JSON number holds 53.
  std::uint64_t bits() const;
  /// Reads a whole number from 0 to `max`.
  std::uint32_t index(std::uint32_t max) const;
  /// Reads a whole number from `min` to `max`.
  std::int64_t whole(std::int64_t min, std::int64_t max) const;
  /// Reads a hex float as a string, or a JSON number, which is rounded once.
  double number() const;
  /// Reads such a number, or the word "infinite" for what is beyond the largest.
  double number_or_infinite() const;
  Eigen::Vector3d point() const;

 private:
  JsonCursor(const JsonCursor& parent, std::string_view key);
  JsonCursor(const JsonCursor& parent, std::size_t index);

  const JsonValue* find(std::string_view key) const;
  void require(JsonKind kind) const;
  std::string pointer() const;

  const JsonValue& value_;
  const std::string& file_;
  const JsonCursor* parent_ = nullptr;
  std::string_view key_;
  std::size_t index_ = 0;
};

/// Calls `make()` and gives its error the place that the cursor stands at.
template <typename Make>
auto at_place(const JsonCursor& at, Make&& make) {
  try {
    return make();
  } catch (const Error& error) {
    at.fail(error.what());
  }
}

}  // namespace graze::cases
