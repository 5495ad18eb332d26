#pragma once

#include <graze/engine/mesh/load_mesh.h>
#include <gtest/gtest.h>
#include <tests/files/temporary_directory.h>

#include <string>
#include <string_view>

namespace graze::mesh_io {

using tests::TemporaryDirectory;

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
