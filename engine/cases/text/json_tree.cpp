#include <graze/bvh/error.h>
#include <graze/engine/cases/text/json_tree.h>
#include <graze/engine/files/source.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

namespace graze::cases {
namespace {

/// Says how far the parser has read. It has always read the last byte of the token that it reports,
/// and one byte more of a number.
struct Reading {
  const char* begin;
  const char* at;
  std::size_t line = 1;
  const char* counted;  ///< lines are counted up to here

  std::size_t line_now() {
    const char* const last = at == begin ? begin : at - 1;
    if (last > counted) {
      line += static_cast<std::size_t>(std::count(counted, last, '\n'));
      counted = last;
    }
    return line;
  }
};

/// Iterates over characters, and notes how far they have been read.
class NotedIterator {
 public:
  // NOLINTBEGIN(readability-identifier-naming): what the standard asks iterators for
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;
  // NOLINTEND(readability-identifier-naming)

  NotedIterator(const char* at, Reading* reading) : at_(at), reading_(reading) {}
  reference operator*() const { return *at_; }
  NotedIterator& operator++() {
    reading_->at = ++at_;
    return *this;
  }
  NotedIterator operator++(int) {
    NotedIterator old = *this;
    ++*this;
    return old;
  }
  bool operator==(const NotedIterator& other) const { return at_ == other.at_; }
  bool operator!=(const NotedIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  Reading* reading_;
};

/// Receives what the parser sees and builds the tree. Its loop does not recurse, however deep a
/// text nests.
class Builder {
 public:
  Builder(Reading& reading, const std::string& name, const JsonLimits& limits)
      : reading_(reading), name_(name), limits_(limits) {}

  JsonValue take() { return std::move(root_); }

  bool null() { return add(JsonKind::Null), true; }
  bool boolean(bool value) {
    add(JsonKind::Boolean).content = value;
    return true;
  }
  bool number_integer(std::int64_t value) { return add_whole(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) { return add_whole(static_cast<double>(value)); }
  bool number_float(double value, const std::string& text) {
    if (!std::isfinite(value)) fail_here(mesh_io::quoted(text) + " is not finite");
    add(JsonKind::Number).content = value;
    return true;
  }
  bool string(std::string& value) {
    add(JsonKind::String).content = std::move(value);
    return true;
  }
  bool binary(std::vector<std::uint8_t>&) { return false; }  // a text has no binary values
  bool start_object(std::size_t) {
    open(JsonKind::Object).content = std::make_unique<JsonValue::Members>();
    return true;
  }
  bool start_array(std::size_t) {
    open(JsonKind::Array).content = std::vector<JsonValue>();
    return true;
  }
  bool end_object() { return open_.pop_back(), true; }
  bool end_array() { return open_.pop_back(), true; }

  bool key(std::string& key) {
    std::vector<std::string>& keys = keys_of(*open_.back());
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) {
      fail("the key " + mesh_io::quoted(key) + " stands twice in one object");
    }
    if (keys.size() == limits_.members) {
      fail("an object with more than " + std::to_string(limits_.members) + " members");
    }
    keys.push_back(std::move(key));
    return true;
  }

  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception& error) {
    // The error reads "[json.exception.parse_error.101] parse error at line 3, column 5: syntax
    // error ...": the line is told already.
    std::string why = error.what();
    for (const char* mark : {"] ", ": "}) {
      const std::size_t end = why.find(mark);
      if (end != why.npos) why.erase(0, end + 2);
    }
    fail_here("not JSON: " + why);
  }

 private:
  static std::vector<std::string>& keys_of(const JsonValue& object) {
    return std::get<std::unique_ptr<JsonValue::Members>>(object.content)->keys;
  }

  /// Returns the JSON pointer of the value that is being read; empty where none is.
  std::string place() const {
    std::string place;
    for (const JsonValue* each : open_) {
      const bool is_innermost = each == open_.back();
      const std::size_t read = each->items().size();
      if (each->kind == JsonKind::Array) {
        place += '/';
        place += std::to_string(is_innermost ? read : read - 1);
      } else if (!is_innermost || keys_of(*each).size() > read) {
        place += '/';
        place += keys_of(*each).back();
      }
    }
    return place;
  }

  [[noreturn]] void fail_here(const std::string& why) {
    const std::string where = place();
    fail(where.empty() ? why : mesh_io::printable(where) + ": " + why);
  }

  [[noreturn]] void fail(const std::string& why) {
    throw CaseError(name_ + ":" + std::to_string(reading_.line_now()) + ": " + why,
                    {.file = name_, .line = reading_.line_now()});
  }

  JsonValue& add(JsonKind kind) {
    if (++values_ > limits_.values) {
      fail("more than " + std::to_string(limits_.values) + " values");
    }
    JsonValue& value = open_.empty() ? root_ : open_.back()->items().emplace_back();
    value.kind = kind;
    constexpr std::size_t kMostLines = std::numeric_limits<std::uint32_t>::max();
    value.line = static_cast<std::uint32_t>(std::min(reading_.line_now(), kMostLines));
    return value;
  }

  bool add_whole(double number) {
    JsonValue& value = add(JsonKind::Number);
    value.content = number;
    value.is_whole = true;
    return true;
  }

  JsonValue& open(JsonKind kind) {
    if (open_.size() == limits_.depth) {
      fail("nested deeper than " + std::to_string(limits_.depth) + " levels");
    }
    // A value stays where it is while it is open: only the innermost list grows.
    open_.push_back(&add(kind));
    return *open_.back();
  }

  Reading& reading_;
  const std::string& name_;
  JsonLimits limits_;
  JsonValue root_;
  std::vector<JsonValue*> open_;
  std::size_t values_ = 0;
};

}  // namespace

JsonValue parse_json(std::string_view bytes, const std::string& name, const JsonLimits& limits) {
  Reading reading = {bytes.data(), bytes.data(), 1, bytes.data()};
  Builder builder(reading, name, limits);
  nlohmann::json::sax_parse(NotedIterator(bytes.data(), &reading),
                            NotedIterator(bytes.data() + bytes.size(), &reading), &builder);
  return builder.take();
}

const char* name_of(JsonKind kind) {
  switch (kind) {
    case JsonKind::Null:
      return "null";
    case JsonKind::Boolean:
      return "a boolean";
    case JsonKind::Number:
      return "a number";
    case JsonKind::String:
      return "a string";
    case JsonKind::Array:
      return "an array";
    case JsonKind::Object:
      return "an object";
  }
  return "nothing";
}

}  // namespace graze::cases
