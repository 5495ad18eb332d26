#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace graze::cases {

enum class JsonKind { Null, Boolean, Number, String, Array, Object };

/// A JSON value that knows the line on which it stands.
struct JsonValue {
  JsonKind kind = JsonKind::Null;
  bool boolean = false;
  bool is_whole = false;  ///< a number written without fraction and exponent
  std::size_t line = 0;   ///< counted from 1
  double number = 0;
  std::string text;               ///< of a string
  std::vector<std::string> keys;  ///< of an object, in the order of the file
  std::vector<JsonValue> items;   ///< of an array, or the values of the keys
};

/// Files that ask for more than this are refused before they cost memory.
struct JsonLimits {
  std::size_t depth = 32;
  std::size_t values = std::size_t{1} << 24;
  std::size_t members = 64;  ///< of one object
};

/// Parses one JSON text. Throws CaseError `name:line: why` for what is no JSON, for a key that
/// stands twice in an object, and beyond a limit. Linear time.
JsonValue parse_json(std::string_view bytes, const std::string& name,
                     const JsonLimits& limits = {});

/// The name of a kind for messages: "an array".
const char* name_of(JsonKind kind);

}  // namespace graze::cases
