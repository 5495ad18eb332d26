#include <graze/engine/mesh/io/format.h>

#include <cstddef>
#include <cstdint>

// Whatever bytes a file holds, a reader ends with a mesh or with a MeshError. Each input goes to
// every reader, so that a seed is simply a file.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const graze::mesh_io::Source source{"file", {reinterpret_cast<const char*>(data), size}};
  for (const graze::mesh_io::Format& format : graze::mesh_io::all_formats()) {
    try {
      const graze::mesh_io::MeshArrays arrays = format.read(source, {});
      static_cast<void>(graze::Mesh(arrays.vertices, arrays.triangles));
    } catch (const graze::MeshError&) {
      // What is wrong with an input is no finding.
    }
  }
  return 0;
}
