#include <graze/engine/files/source.h>
#include <graze/engine/record/coding/blocks.h>
#include <graze/engine/record/coding/byte_reader.h>
#include <graze/engine/record/recording.h>

#include <zlib.h>

#include <algorithm>
#include <istream>
#include <limits>
#include <new>

namespace graze::record {
namespace {

// At most so many bytes are read at once, so that a wrong length does not take the memory that it
// says.
constexpr std::size_t kReadAtOnce = std::size_t{1} << 20;
// Deflate makes at most so many equal bytes of one: 258 of them from two bits, and some room.
constexpr std::uint64_t kMostUnpackedOfByte = 1040;

std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

void append_u32(std::uint32_t value, std::string& to) {
  for (int shift = 0; shift < 32; shift += 8)
    to += static_cast<char>(value >> shift & 0xff);
}

std::uint32_t u32_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k)
    value |= std::uint32_t{static_cast<unsigned char>(bytes[at + k])} << 8 * k;
  return value;
}

bool is_known(char kind) {
  return std::string_view("HGWUE").find(kind) != std::string_view::npos;
}

}  // namespace

void append_block(BlockKind kind, std::string_view content, std::string& to) {
  if (content.size() > std::numeric_limits<std::uint32_t>::max())
    throw InputError("record: a shape or an update of more than 4 GiB");
  const std::size_t front = to.size();
  to += static_cast<char>(kind);
  append_u32(static_cast<std::uint32_t>(content.size()), to);
  append_u32(checksum(std::string_view(to).substr(front)), to);
  to += content;
  append_u32(checksum(content), to);
}

BlockReader::BlockReader(std::istream& stream, const std::string& name)
    : stream_(stream), name_(name) {
  std::string bytes;
  const bool is_whole = fill(bytes, kMagic.size() + 4);
  if (!std::string_view(bytes).starts_with(kMagic)) fail(0, "is no recording of a world");
  if (!is_whole) fail(bytes.size(), "ends before there is a world");
  const std::uint32_t format = u32_at(bytes, kMagic.size());
  if (format != kFormat) {
    fail(kMagic.size(), "is of format version " + std::to_string(format) + "; this graze reads " +
                            std::to_string(kFormat));
  }
  offset_ = bytes.size();
}

bool BlockReader::fill(std::string& bytes, std::size_t count) {
  bytes.clear();
  while (bytes.size() < count) {
    const std::size_t part = std::min(count - bytes.size(), kReadAtOnce), had = bytes.size();
    bytes.resize(had + part);
    stream_.read(bytes.data() + had, static_cast<std::streamsize>(part));
    const auto got = static_cast<std::size_t>(stream_.gcount());
    if (stream_.bad()) fail(offset_, "cannot be read");
    if (got == part) continue;
    bytes.resize(had + got);
    return false;
  }
  return true;
}

bool BlockReader::read(Block& block) {
  std::string front;
  if (!fill(front, kFrontBytes)) return false;
  if (u32_at(front, 5) != checksum(std::string_view(front).substr(0, 5)))
    fail(offset_, "the front of a block is damaged: its checksum differs");
  if (!is_known(front[0])) fail(offset_, "a block of an unknown kind");
  block.kind = static_cast<BlockKind>(front[0]);
  block.offset = offset_ + kFrontBytes;
  const std::size_t length = u32_at(front, 1);
  if (!fill(block.content, length + kBackBytes)) return false;
  const std::string_view content = std::string_view(block.content).substr(0, length);
  if (u32_at(block.content, length) != checksum(content))
    fail(block.offset, "a block is damaged: its checksum differs");
  block.content.resize(length);
  offset_ += kFrontBytes + length + kBackBytes;
  return true;
}

void BlockReader::fail(std::uint64_t at, const std::string& why) const {
  ByteReader({}, name_, at).fail(why);
}

std::string packed(std::string_view content) {
  ByteWriter front;
  uLongf length = compressBound(static_cast<uLong>(content.size()));
  std::string bytes(length, '\0');
  const int status = compress2(reinterpret_cast<Bytef*>(bytes.data()), &length,
                               reinterpret_cast<const Bytef*>(content.data()),
                               static_cast<uLong>(content.size()), Z_DEFAULT_COMPRESSION);
  if (status != Z_OK) throw std::bad_alloc();
  const bool is_shorter = length < content.size();
  front.byte(is_shorter ? 1 : 0);
  front.number(content.size());
  std::string whole(front.view());
  return whole.append(is_shorter ? std::string_view(bytes).substr(0, length) : content);
}

std::string unpacked(ByteReader& from) {
  const std::uint8_t is_packed = from.flags(1, "packing");
  const std::uint64_t length = from.number();
  if (is_packed == 0) {
    if (length != from.remaining()) from.fail("a shape of another length than it says");
    return std::string(from.raw(length));
  }
  if (length > kMostUnpackedOfByte * from.remaining())
    from.fail("a shape that unpacks to more than it can");
  const std::string_view bytes = from.raw(from.remaining());
  std::string content(static_cast<std::size_t>(length), '\0');
  uLongf got = static_cast<uLongf>(length);
  const int status =
      uncompress(reinterpret_cast<Bytef*>(content.data()), &got,
                 reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()));
  if (status == Z_MEM_ERROR) throw std::bad_alloc();
  if (status != Z_OK || got != length) from.fail("a shape that does not unpack");
  return content;
}

}  // namespace graze::record
