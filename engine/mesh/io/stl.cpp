#include <graze/engine/mesh/io/byte_cursor.h>
#include <graze/engine/mesh/io/readers.h>
#include <graze/engine/mesh/io/text_cursor.h>

namespace graze::mesh_io {
namespace {

constexpr std::size_t kStlPrefixBytes = kStlHeaderBytes + sizeof(std::uint32_t);

/// True if the size is that of a binary file. Text cannot pass for one: four printable characters,
/// read as a count, ask for gigabytes.
bool has_binary_size(const Source& source) {
  if (source.bytes.size() < kStlPrefixBytes) return false;
  ByteCursor cursor(source, kStlHeaderBytes, std::endian::little);
  const std::uint64_t count = cursor.read<std::uint32_t>("the triangle count");
  return cursor.remaining() == count * kStlTriangleBytes;
}

/// True if the file looks like text. A truncated binary file may begin with "solid" as well, but
/// there are zeros in its beginning.
bool looks_like_text(const Source& source) {
  TextCursor cursor(source, {});
  constexpr std::string_view kZero("\0", 1);
  if (!cursor.find_token() || !is_keyword(cursor.token(), "solid")) return false;
  return source.bytes.substr(0, kStlPrefixBytes + kStlTriangleBytes).find(kZero) ==
         std::string_view::npos;
}

}  // namespace

MeshArrays read_stl(const Source& source, const ReadSettings& settings) {
  if (has_binary_size(source)) return read_stl_binary(source, settings);
  if (looks_like_text(source)) return read_stl_ascii(source, settings);
  if (source.bytes.size() < kStlPrefixBytes) {
    fail(source,
         "neither text that begins with \"solid\" nor the 84 bytes of a binary STL's header");
  }
  return read_stl_binary(source, settings);
}

}  // namespace graze::mesh_io
