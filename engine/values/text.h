#pragma once

// This is private to engine/values.

#include <graze/engine/mesh/triangle_pairs.h>
#include <Eigen/Core>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <ostream>
#include <string>
#include <string_view>

namespace graze {

inline constexpr std::size_t kMostElements = 16;

/// Text that grows. What the stream has set changes nothing in it.
class Text {
 public:
  template <typename... Parts>
  explicit Text(const Parts&... parts) {
    (add(parts), ...);
  }

  void add(std::string_view text) { text_ += text; }
  void add(double number) {
    char digits[32];
    text_.append(digits, std::to_chars(digits, std::end(digits), number).ptr);
  }
  void add(std::uint64_t number) { text_ += std::to_string(number); }
  void add(std::uint32_t number) { add(std::uint64_t{number}); }
  void add(const Eigen::Vector3d& point) {
    const double* p = point.data();
    add("("), add(p[0]), add(", "), add(p[1]), add(", "), add(p[2]), add(")");
  }

  const std::string& str() const { return text_; }

 private:
  std::string text_;
};

inline std::ostream& operator<<(std::ostream& out, const Text& text) {
  return out << text.str();
}

/// Writes how long a list is, and its first elements.
template <typename List>
std::ostream& write_list(std::ostream& out, const List& list, const char* of) {
  out << Text(std::uint64_t{list.size()}, " ", of, list.empty() ? "" : ":");
  const std::size_t shown = std::min(list.size(), kMostElements);
  auto element = list.begin();
  for (std::size_t i = 0; i < shown; ++i, ++element)
    out << Text(" ") << *element;
  if (shown < list.size()) out << Text(" and ", std::uint64_t{list.size() - shown}, " more");
  return out;
}

/// Writes a list as write_list() does, and says if a limit may have cut it.
template <typename List>
std::ostream& write_limited(std::ostream& out, const List& list, const char* of) {
  write_list(out, list, of);
  return list.completeness == Completeness::LimitReached ? out << Text(" (limit reached)") : out;
}

}  // namespace graze
