#include <graze/engine/files/source.h>
#include <graze/engine/record/coding/byte_reader.h>
#include <graze/engine/record/recording.h>

#include <cstring>

namespace graze::record {

std::uint64_t ByteReader::word() {
  require(sizeof(std::uint64_t));
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, bytes_.data() + at_, sizeof bytes);
  at_ += sizeof bytes;
  return lowest_first(bytes);
}

std::uint64_t ByteReader::number() {
  std::uint64_t value = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    const std::uint8_t part = byte();
    const std::uint64_t bits = part & 0x7fU;
    if (shift == 63 && bits > 1) break;
    value |= bits << shift;
    if (part < 0x80) return value;
  }
  fail("a number of more than 64 bits");
}

std::uint32_t ByteReader::number_up_to(std::uint64_t most, const char* what) {
  const std::uint64_t value = number();
  if (value > most)
    fail(std::string(what) + ": " + std::to_string(value) + " is beyond " + std::to_string(most));
  return static_cast<std::uint32_t>(value);
}

std::size_t ByteReader::count(std::size_t least_bytes_each, const char* what) {
  const std::uint64_t value = number();
  if (value > remaining() / least_bytes_each)
    fail(std::string(what) + ": " + std::to_string(value) + " do not fit into what follows");
  return static_cast<std::size_t>(value);
}

std::uint8_t ByteReader::flags(std::uint8_t known, const char* what) {
  const std::uint8_t value = byte();
  if ((value & ~known) != 0) fail(std::string(what) + ": unknown bits");
  return value;
}

void ByteReader::fail(const std::string& why) const {
  const std::uint64_t at = offset_ + (is_packed_ ? 0 : at_);
  throw RecordingError(
      mesh_io::printable(name_) + ": byte " + std::to_string(at) + ": " + why,
      {.file = name_, .byte = static_cast<std::size_t>(at), .element = {}, .index = {}});
}

}  // namespace graze::record
