#pragma once

// The frame of a recording: a sequence of blocks, each with a checksum of its own.

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

namespace graze::record {

inline constexpr std::string_view kMagic = "GRAZEREC";
inline constexpr std::uint32_t kFormat = 1;

/// What a block holds.
enum class BlockKind : std::uint8_t { Head = 'H', Shape = 'G', State = 'W', Step = 'U', End = 'E' };

/// What stands before each block's content: kind, 1, its length, 4, and the checksum of these five
/// bytes, 4. Behind the content stands its checksum, 4.
inline constexpr std::size_t kFrontBytes = 9, kBackBytes = 4;

/// The block with what stands around it.
void append_block(BlockKind kind, std::string_view content, std::string& to);

/// A block that was read.
struct Block {
  BlockKind kind{};
  std::uint64_t offset = 0;  ///< of its content in the file
  std::string content;
};

/// Reads block after block.
class BlockReader {
 public:
  /// Reads what stands before the first one. `name` must outlive this. Throws RecordingError.
  BlockReader(std::istream& stream, const std::string& name);

  /// The next one; false where the file ends, within a block or before one. Throws RecordingError
  /// for what is damaged. The memory of `block` is used again.
  bool read(Block& block);

  /// Of whole blocks so far, with what stands before them.
  std::uint64_t bytes() const { return offset_; }
  [[noreturn]] void fail(std::uint64_t at, const std::string& why) const;

 private:
  bool fill(std::string& bytes, std::size_t count);

  std::istream& stream_;
  const std::string& name_;
  std::uint64_t offset_ = 0;
};

/// Large content packed by zlib, or as it is where that is no shorter: a byte that says which, the
/// length of the unpacked and the rest.
std::string packed(std::string_view content);

/// Throws RecordingError for what is not packed so.
class ByteReader;
std::string unpacked(ByteReader& from);

}  // namespace graze::record
