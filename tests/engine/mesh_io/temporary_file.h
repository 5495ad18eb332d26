#pragma once

#include <graze/engine/mesh/load_mesh.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace graze::mesh_io {

/// A directory for the files of one test, removed at its end.
class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    const std::string pattern = (std::filesystem::temp_directory_path() / "graze_XXXXXX").string();
    path_ = pattern;
    if (mkdtemp(path_.data()) == nullptr) throw std::runtime_error("no temporary directory");
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  std::string path(std::string_view name) const { return path_ + "/" + std::string(name); }

  std::string write(std::string_view name, std::string_view bytes) const {
    std::ofstream file(path(name), std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) throw std::runtime_error("cannot write " + path(name));
    return path(name);
  }

 private:
  std::string path_;
};

/// The mesh that load_mesh() makes of a file with this name and content.
inline Mesh load(std::string_view name, std::string_view bytes) {
  const TemporaryDirectory directory;
  return load_mesh(directory.write(name, bytes));
}

/// What load_mesh() says of a file, without the directory; empty if it accepts it.
inline std::string error_of(std::string_view name, std::string_view bytes) {
  const TemporaryDirectory directory;
  const std::string path = directory.write(name, bytes);
  try {
    load_mesh(path);
  } catch (const MeshError& error) {
    const std::string what = error.what();
    EXPECT_TRUE(what.starts_with(path)) << what;
    return what.substr(path.size() - name.size());
  }
  return {};
}

}  // namespace graze::mesh_io
