#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace graze::cases {

enum class JsonKind : std::uint8_t { Null, Boolean, Number, String, Array, Object };

/// A JSON value that knows the line on which it stands. A mesh has a dozen of them for each
/// triangle, so that a value holds what its kind needs and no more.
struct JsonValue {
  struct Members;

  JsonKind kind = JsonKind::Null;
  bool is_whole = false;   ///< true for a number written without fraction and exponent
  std::uint32_t line = 0;  ///< counted from 1, up to the largest there is
  std::variant<double, bool, std::string, std::vector<JsonValue>, std::unique_ptr<Members>> content;

  /// Return the items of an array, or the values of an object's keys.
  const std::vector<JsonValue>& items() const;
  std::vector<JsonValue>& items();
};

struct JsonValue::Members {
  std::vector<std::string> keys;  ///< the keys in the order of the file
  std::vector<JsonValue> values;
};

inline const std::vector<JsonValue>& JsonValue::items() const {
  if (kind == JsonKind::Object) return std::get<std::unique_ptr<Members>>(content)->values;
  return std::get<std::vector<JsonValue>>(content);
}

inline std::vector<JsonValue>& JsonValue::items() {
  if (kind == JsonKind::Object) return std::get<std::unique_ptr<Members>>(content)->values;
  return std::get<std::vector<JsonValue>>(content);
}

/// Holds limits: files that ask for more are refused before they cost memory.
struct JsonLimits {
  std::size_t depth = 32;
  std::size_t values = std::size_t{1} << 24;
  std::size_t members = 64;  ///< the members of one object
};

/// Parses one JSON text. Throws CaseError `name:line: why` for what is no JSON, for a key that
/// stands twice in an object, and beyond a limit. Takes linear time.
JsonValue parse_json(std::string_view bytes, const std::string& name,
                     const JsonLimits& limits = {});

/// Returns the name of a kind for messages: "an array".
const char* name_of(JsonKind kind);

}  // namespace graze::cases
