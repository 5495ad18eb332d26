#pragma once

// A recording is framed as a sequence of blocks, each with a checksum of its own.

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

namespace graze::record {

inline constexpr std::string_view kMagic = "GRAZEREC";
inline constexpr std::uint32_t kFormat = 1;

/// Says what a block holds.
enum class BlockKind : std::uint8_t { Head = 'H', Shape = 'G', State = 'W', Step = 'U', End = 'E' };

/// The bytes before each block's content are its kind, 1, its length, 4, and the checksum of these
/// five bytes, 4. Behind the content stands its checksum, 4.
inline constexpr std::size_t kFrontBytes = 9, kBackBytes = 4;

/// Appends the block with what stands around it.
void append_block(BlockKind kind, std::string_view content, std::string& to);

/// Holds a block that was read.
struct Block {
  BlockKind kind{};
  std::uint64_t offset = 0;  ///< where its content stands in the file
  std::string content;
};

/// Reads block after block.
class BlockReader {
 public:
  /// Reads what stands before the first block. `name` must outlive this. Throws RecordingError.
  BlockReader(std::istream& stream, const std::string& name);

  /// Reads the next block; false where the file ends, within a block or before one. Throws
  /// RecordingError for damaged blocks. The memory of `block` is used again.
  bool read(Block& block);

  /// Returns how many bytes whole blocks have taken so far, with what stands before them.
  std::uint64_t bytes() const { return offset_; }
  [[noreturn]] void fail(std::uint64_t at, const std::string& why) const;

 private:
  bool fill(std::string& bytes, std::size_t count);

  std::istream& stream_;
  const std::string& name_;
  std::uint64_t offset_ = 0;
};

/// Packs large content by zlib, or leaves it as it is where that is no shorter: a byte says which,
/// then come the unpacked length and the rest.
std::string packed(std::string_view content);

/// Unpacks what packed() made. Throws RecordingError for anything else.
class ByteReader;
std::string unpacked(ByteReader& from);

}  // namespace graze::record
