#include <graze/bvh/error.h>
#include <graze/engine/cases/text/hex_float.h>
#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/files/source.h>

#include <algorithm>
#include <charconv>
#include <limits>

namespace graze::cases {

JsonCursor::JsonCursor(const JsonCursor& parent, std::string_view key)
    : value_(*parent.find(key)), file_(parent.file_), parent_(&parent), key_(key) {}

JsonCursor::JsonCursor(const JsonCursor& parent, std::size_t index)
    : value_(parent.value_.items()[index]), file_(parent.file_), parent_(&parent), index_(index) {}

std::string JsonCursor::pointer() const {
  if (parent_ == nullptr) return "";
  const std::string step =
      parent_->value_.kind == JsonKind::Array ? std::to_string(index_) : std::string(key_);
  return parent_->pointer() + "/" + step;
}

void JsonCursor::fail(const std::string& why) const {
  const std::string place = pointer();
  throw CaseError(
      file_ + ":" + std::to_string(value_.line) + ": " + (place.empty() ? "" : place + ": ") + why,
      {.file = std::string(file_), .line = value_.line, .element = place});
}

void JsonCursor::require(JsonKind kind) const {
  if (value_.kind == kind) return;
  fail(std::string("is ") + name_of(value_.kind) + ", not " + name_of(kind));
}

const JsonValue* JsonCursor::find(std::string_view key) const {
  require(JsonKind::Object);
  const JsonValue::Members& members =
      *std::get<std::unique_ptr<JsonValue::Members>>(value_.content);
  const auto at = std::find(members.keys.begin(), members.keys.end(), key);
  if (at == members.keys.end()) return nullptr;
  return &members.values[static_cast<std::size_t>(at - members.keys.begin())];
}

void JsonCursor::require_keys(std::initializer_list<std::string_view> known) const {
  require(JsonKind::Object);
  for (const std::string& stands :
       std::get<std::unique_ptr<JsonValue::Members>>(value_.content)->keys) {
    if (std::find(known.begin(), known.end(), stands) != known.end()) continue;
    std::string list;
    for (const std::string_view key : known)
      list += (list.empty() ? "" : ", ") + std::string(key);
    fail("unknown key " + mesh_io::quoted(stands) + "; there are " + list);
  }
}

JsonCursor JsonCursor::member(std::string_view key) const {
  if (find(key) == nullptr) fail("has no " + mesh_io::quoted(key));
  return {*this, key};
}

std::size_t JsonCursor::size() const {
  require(JsonKind::Array);
  return value_.items().size();
}

void JsonCursor::require_size(std::size_t wanted) const {
  if (size() == wanted) return;
  fail("has " + std::to_string(size()) + " elements, not " + std::to_string(wanted));
}

bool JsonCursor::boolean() const {
  require(JsonKind::Boolean);
  return std::get<bool>(value_.content);
}

const std::string& JsonCursor::text() const {
  require(JsonKind::String);
  return std::get<std::string>(value_.content);
}

std::uint64_t JsonCursor::bits() const {
  const std::string& all = text();
  std::uint64_t value = 0;
  const char* end = all.data() + all.size();
  const bool has_prefix = all.starts_with("0x") && all.size() > 2 && all.size() <= 18 &&
                          all.find_first_not_of("0123456789abcdef", 2) == std::string::npos;
  if (!has_prefix || std::from_chars(all.data() + 2, end, value, 16).ptr != end) {
    fail(mesh_io::quoted(all) + " is not 0x and up to 16 digits 0-9 a-f");
  }
  return value;
}

std::uint32_t JsonCursor::index(std::uint32_t max) const {
  return static_cast<std::uint32_t>(whole(0, max));
}

// The tree keeps whole numbers as doubles, which are exact to 2^53, beyond every range asked for.
std::int64_t JsonCursor::whole(std::int64_t min, std::int64_t max) const {
  require(JsonKind::Number);
  const double value = std::get<double>(value_.content);
  if (!value_.is_whole || value < static_cast<double>(min) || value > static_cast<double>(max)) {
    fail("is not a whole number from " + std::to_string(min) + " to " + std::to_string(max));
  }
  return static_cast<std::int64_t>(value);
}

double JsonCursor::number() const {
  if (value_.kind == JsonKind::Number) return std::get<double>(value_.content);
  if (value_.kind != JsonKind::String) {
    fail(std::string("is ") + name_of(value_.kind) + ", not a number");
  }
  const std::string& digits = std::get<std::string>(value_.content);
  const std::optional<double> value = parse_hex_float(digits);
  if (!value) {
    fail(mesh_io::quoted(digits) + " is not a finite double as a hex float, such as \"0x1.8p+1\"");
  }
  return *value;
}

double JsonCursor::number_or_infinite() const {
  const bool is_infinite =
      value_.kind == JsonKind::String && std::get<std::string>(value_.content) == kInfinite;
  return is_infinite ? std::numeric_limits<double>::infinity() : number();
}

Eigen::Vector3d JsonCursor::point() const {
  require_size(3);
  Eigen::Vector3d result;
  for (int axis = 0; axis < 3; ++axis)
    result[axis] = item(static_cast<std::size_t>(axis)).number();
  return result;
}

}  // namespace graze::cases
