#pragma once

#include <charconv>
#include <filesystem>
#include <string>

namespace graze::generator {

/// The shortest decimal that reads back as the same number, independent of the locale.
template <typename Number>
std::string shortest(Number value) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, result.ptr};
}

/// Writes the bytes as they are. Throws std::runtime_error, naming the file, if it cannot.
void write_file(const std::filesystem::path& path, const std::string& bytes);

}  // namespace graze::generator
