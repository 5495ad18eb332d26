#include <graze/engine/view/packing/word_arrays.h>

#include <bit>

namespace graze::view {

std::size_t WordArrays::add(std::span<const std::uint32_t> words, std::uint32_t stride) {
  const std::size_t count = words.size();
  places_.push_back({bytes_.size(), count, stride});
  bytes_.resize(bytes_.size() + 4 * count);
  char* out = bytes_.data() + places_.back().offset;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t difference = words[i] - (i < stride ? 0 : words[i - stride]);
    const std::uint32_t sign = difference >> 31 != 0 ? ~0u : 0u;
    const std::uint32_t zigzag = difference << 1 ^ sign;
    for (unsigned plane = 0; plane < 4; ++plane)
      out[plane * count + i] = static_cast<char>(zigzag >> 8 * plane & 0xff);
  }
  return places_.size() - 1;
}

std::size_t WordArrays::add(std::span<const float> floats, std::uint32_t stride) {
  std::vector<std::uint32_t> words;
  words.reserve(floats.size());
  for (const float number : floats)
    words.push_back(std::bit_cast<std::uint32_t>(number));
  return add(words, stride);
}

}  // namespace graze::view
