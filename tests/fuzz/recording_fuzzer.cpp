#include <graze/bvh/error.h>
#include <graze/engine/record/coding/blocks.h>
#include <graze/engine/record/replay_recording.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>

// Whatever the bytes are, reading and repeating them ends with an error of the library or an
// answer. Checksums would let no mutation in: so the bytes are a file as it is, or the blocks of
// one without their frames, which are put around them here.

using namespace graze;

namespace {

constexpr std::string_view kKinds = "HGWUE";

/// Each block is a kind, two bytes of length and so many bytes, as far as there are any.
std::string framed(std::string_view bytes) {
  std::string file(record::kMagic);
  for (int shift = 0; shift < 32; shift += 8)
    file += static_cast<char>(record::kFormat >> shift & 0xff);
  while (bytes.size() >= 3) {
    const auto kind = static_cast<record::BlockKind>(
        kKinds[static_cast<unsigned char>(bytes[0]) % kKinds.size()]);
    const std::size_t length = static_cast<unsigned char>(bytes[1]) |
                               static_cast<std::size_t>(static_cast<unsigned char>(bytes[2])) << 8;
    const std::string_view content = bytes.substr(3, length);
    record::append_block(kind, content, file);
    bytes.remove_prefix(3 + content.size());
  }
  return file;
}

void repeat(std::string bytes) {
  try {
    RecordingReplay replay(
        RecordingReader(std::make_unique<std::istringstream>(std::move(bytes)), "bytes"));
    while (replay.advance()) {
    }
  } catch (const Error&) {  // what is wrong with an input is no finding
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  repeat(bytes.starts_with(record::kMagic) ? std::string(bytes) : framed(bytes));
  return 0;
}
