#include <graze/engine/view/packing/packed_text.h>

#include <graze/bvh/error.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>

namespace graze::view {
namespace {

/// Ends zlib's state, whatever happens.
class Deflater {
 public:
  Deflater() {
    constexpr int kLevel = 9, kGzip = 15 + 16, kMemory = 9;
    if (deflateInit2(&stream_, kLevel, Z_DEFLATED, kGzip, kMemory, Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::bad_alloc();
  }
  ~Deflater() { deflateEnd(&stream_); }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;

  z_stream& stream() { return stream_; }

 private:
  z_stream stream_ = {};
};

}  // namespace

std::string gzipped(std::string_view bytes) {
  constexpr std::size_t kPart = std::size_t{1} << 20;
  Deflater deflater;
  z_stream& stream = deflater.stream();
  std::string out;
  std::array<char, 1u << 16> buffer;
  for (std::size_t at = 0;;) {
    const std::string_view part = bytes.substr(at, kPart);
    at += part.size();
    const bool is_last = at == bytes.size();
    std::string copy(part);  // zlib takes what it reads for writable
    stream.next_in = reinterpret_cast<Bytef*>(copy.data());
    stream.avail_in = static_cast<uInt>(copy.size());
    do {
      stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
      stream.avail_out = static_cast<uInt>(buffer.size());
      deflate(&stream, is_last ? Z_FINISH : Z_NO_FLUSH);
      out.append(buffer.data(), buffer.size() - stream.avail_out);
    } while (stream.avail_out == 0);
    if (out.size() > kMostPackedBytes)
      throw InputError("a view of more than " + std::to_string(kMostPackedBytes >> 20) +
                       " MiB, packed: no browser would open its page");
    if (is_last) return out;
  }
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      out += k <= count ? kDigits[bits >> (18 - 6 * k) & 63u] : '=';
  }
  return out;
}

std::string html_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

}  // namespace graze::view
