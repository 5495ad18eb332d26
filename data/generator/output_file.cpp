#include "data/generator/output_file.h"

#include <fstream>
#include <stdexcept>

namespace graze::generator {

void write_file(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) throw std::runtime_error(path.string() + ": cannot write");
}

}  // namespace graze::generator
