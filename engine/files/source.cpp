#include <graze/bvh/error.h>
#include <graze/engine/files/source.h>

#include <utility>

namespace graze::mesh_io {
namespace {

constexpr std::size_t kQuotedCharacters = 30;

void append_escaped(std::string& out, unsigned char byte) {
  constexpr char kDigits[] = "0123456789abcdef";
  out += "\\x";
  out += kDigits[byte >> 4];
  out += kDigits[byte & 15];
}

bool is_control(unsigned char byte) {
  return byte < 0x20 || byte == 0x7f;
}

}  // namespace

void fail(const Source& source, std::string_view why) {
  throw MeshError(std::string(source.name) + ": " + std::string(why),
                  {.file = std::string(source.name)});
}

void fail(const Source& source, Place place, std::string_view why) {
  const bool is_line = place.unit == Place::Unit::Line;
  ErrorPlace where{.file = std::string(source.name)};
  (is_line ? where.line : where.byte) = place.at;
  throw MeshError(std::string(source.name) + (is_line ? ":" : ": byte ") +
                      std::to_string(place.at) + ": " + std::string(why),
                  std::move(where));
}

std::string quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text.substr(0, kQuotedCharacters)) {
    const auto byte = static_cast<unsigned char>(c);
    if (is_control(byte) || byte > 0x7f) {
      append_escaped(out, byte);
    } else {
      out += c;
    }
  }
  out += text.size() > kQuotedCharacters ? "...\"" : "\"";
  return out;
}

std::string printable(std::string_view name) {
  std::string out;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (is_control(byte)) {
      append_escaped(out, byte);
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace graze::mesh_io
