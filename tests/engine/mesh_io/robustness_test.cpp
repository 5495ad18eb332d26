#include <graze/engine/mesh/io/format.h>
#include <tests/engine/mesh_io/allocated_bytes.h>
#include <tests/engine/mesh_io/loading.h>
#include <tests/engine/mesh_io/samples.h>

#include <random>

// Whatever bytes a file holds, a reader ends with a mesh or with a MeshError.

namespace graze::mesh_io {
namespace {

const Format& format_of(const std::string& name) {
  return *find_format(name.substr(name.find('.')));
}

/// True for a mesh, false for a MeshError; anything else goes on to the test.
bool is_mesh(const Format& format, std::string_view bytes) {
  // A copy of just this size: a sanitizer sees every byte that is read behind it.
  const std::vector<char> copy(bytes.begin(), bytes.end());
  try {
    const MeshArrays arrays = format.read({"file", {copy.data(), copy.size()}}, {});
    Mesh(arrays.vertices, arrays.triangles);
    return true;
  } catch (const MeshError&) {
    return false;
  }
}

/// Where the last line of the data may be cut: in its last number or behind it.
std::size_t shortest_mesh(const Sample& cube) {
  if (cube.name == "ascii.stl")
    return cube.bytes.find("endsolid") + std::string_view("endsolid").size();
  if (cube.name == "ascii.obj") return 0;  // any number of faces is a mesh
  return cube.bytes.size() - (cube.name.starts_with("ascii") ? 1 : 0);
}

TEST(MeshReaders, EveryPrefixIsAMeshOrAnError) {
  for (const Sample& cube : cubes()) {
    const std::size_t shortest = shortest_mesh(cube);
    for (std::size_t size = 0; size <= cube.bytes.size(); ++size) {
      const bool is_read = is_mesh(format_of(cube.name), cube.bytes.substr(0, size));
      if (shortest == 0) continue;
      EXPECT_EQ(is_read, size >= shortest) << cube.name << " " << size;
    }
  }
}

TEST(MeshReaders, AnObjFileMayEndBehindAnyCorner) {
  const Format& obj = *find_format(".obj");
  const std::string cube = cube_obj();
  const std::size_t faces = cube.find("f ");
  for (std::size_t size = 0; size <= faces; ++size)
    EXPECT_FALSE(is_mesh(obj, cube.substr(0, size)));
  const std::string first = "f 1 3 4 2\n";
  EXPECT_FALSE(is_mesh(obj, cube.substr(0, faces + 4)));
  EXPECT_TRUE(is_mesh(obj, cube.substr(0, faces + 7)));
  EXPECT_TRUE(is_mesh(obj, cube.substr(0, faces + first.size())));
  EXPECT_FALSE(is_mesh(obj, cube.substr(0, faces + first.size() + 3)));
}

/// Changes, inserts, removes or repeats a few bytes, with a taste for those that mean something.
std::string mutate(std::string bytes, std::mt19937& random) {
  constexpr std::string_view kTelling("\0\xff\x7f\x80 \n\r\\#-+/.e0123456789", 24);
  for (std::uint32_t changes = 1 + random() % 3; changes > 0 && !bytes.empty(); --changes) {
    const std::size_t at = random() % bytes.size();
    const std::size_t length = 1 + random() % 8;
    const char byte =
        random() % 2 == 0 ? kTelling[random() % kTelling.size()] : static_cast<char>(random());
    switch (random() % 4) {
      case 0:
        bytes[at] = byte;
        break;
      case 1:
        bytes.insert(at, 1, byte);
        break;
      case 2:
        bytes.erase(at, length);
        break;
      default:
        bytes.insert(at, bytes.substr(random() % bytes.size(), 4 * length));
    }
  }
  return bytes;
}

void mutate_all(int count) {
  for (const Sample& cube : cubes()) {
    std::mt19937 random(1);
    int meshes = 0;
    for (int i = 0; i < count; ++i) {
      meshes += is_mesh(format_of(cube.name), mutate(cube.bytes, random)) ? 1 : 0;
    }
    // Mutations that only ever fail, or only ever pass, would test nothing.
    EXPECT_GT(meshes, 0) << cube.name;
    EXPECT_LT(meshes, count) << cube.name;
  }
}

TEST(MeshReaders, MutationsAreMeshesOrErrors) {
  mutate_all(3000);
}

TEST(MeshReaders, TheSeedsOfTheFuzzerAreMeshes) {
  int seeds = 0;
  const auto folder = std::filesystem::path(GRAZE_DATA_DIR) / "../tests/fuzz/corpus/mesh_file";
  for (const auto& seed : std::filesystem::directory_iterator(folder)) {
    EXPECT_NO_THROW(load_mesh(seed.path())) << seed.path();
    ++seeds;
  }
  EXPECT_GE(seeds, 7);
}

TEST(MeshReadersSlow, MutationsAreMeshesOrErrors) {
  mutate_all(300000);
}

TEST(MeshReaders, MemoryFollowsTheSizeOfTheFileNotItsClaims) {
  std::string stl(80, ' ');
  append(stl, std::endian::little, std::uint32_t{4'000'000'000u});
  const std::string vertices =
      "element vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string face = "element face 4000000000\nproperty list int int vertex_indices\n";
  const std::string list = std::string("element face 1\nproperty list uint uchar vertex_indices\n");
  const std::vector<Sample> samples = {
      {"a.stl", stl},
      {"a.off", "OFF\n4000000000 4000000000 0\n0 0 0\n"},
      {"b.off", "OFF\n3 4000000000 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n"},
      {"a.ply", "ply\nformat ascii 1.0\n" + vertices + face + "end_header\n0 0 0\n"},
      {"b.ply", "ply\nformat ascii 1.0\n" + face + "end_header\n"},
      {"c.ply",
       "ply\nformat binary_little_endian 1.0\n" + vertices + face + "end_header\n0123456789ab"},
      {"d.ply", "ply\nformat binary_big_endian 1.0\n" + face + vertices + "end_header\n"},
      {"e.ply", "ply\nformat binary_little_endian 1.0\n" + list + "end_header\n\xff\xff\xff\xff"},
  };
  const std::size_t before = allocated_bytes();
  for (const Sample& sample : samples) {
    EXPECT_FALSE(is_mesh(format_of(sample.name), sample.bytes)) << sample.name;
  }
  EXPECT_LT(allocated_bytes() - before, 100'000u);
}

}  // namespace
}  // namespace graze::mesh_io
