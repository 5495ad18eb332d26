#pragma once

#include <filesystem>
#include <string>

namespace graze::generator {

/// The shortest decimal that reads back as the same double, independent of the locale.
std::string shortest(double value);

/// Writes the bytes as they are. Throws std::runtime_error, naming the file, if it cannot.
void write_file(const std::filesystem::path& path, const std::string& bytes);

}  // namespace graze::generator
