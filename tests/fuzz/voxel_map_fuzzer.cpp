#include <graze/bvh/error.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/voxel_map.h>
#include <graze/engine/world/world.h>

#include <algorithm>
#include <set>
#include <vector>

#include "tests/fuzz/byte_bodies.h"

// Maps of voxels that come and go one by one and as blocks, beside a set of them; and each question
// about one beside the same about a compound of its boxes.

using namespace graze;
using fuzz::fail_if;

namespace {

/// So many full ones are asked about at most: a compound takes time for each.
constexpr std::size_t kMostFull = 400;

VoxelGrid grid_of(fuzz::ByteShapes& bytes) {
  const int kind = bytes.byte();
  VoxelGrid grid{{-0.5, -0.5, 0}, fuzz::length(bytes), {}};
  if (kind % 2 == 1) grid.origin = bytes.triangle().a;
  for (std::uint32_t& count : grid.counts)
    count = bytes.byte() % 40u;
  return grid;
}

Voxel voxel_of(fuzz::ByteShapes& bytes) {
  const auto at = [&] { return static_cast<std::uint16_t>(bytes.byte() % 42); };
  const std::uint16_t i = at(), j = at();
  return {i, j, at()};
}

bool is_of(const VoxelGrid& grid, const Voxel& voxel) {
  return voxel.i < grid.counts[0] && voxel.j < grid.counts[1] && voxel.k < grid.counts[2];
}

/// Whether the change was taken, which it must be exactly if it is of the grid.
template <typename Change>
bool is_taken(bool is_good, const Change& change) {
  try {
    change();
    fail_if(!is_good, "what is not of the grid was taken");
    return true;
  } catch (const InputError&) {
    fail_if(is_good, "what is of the grid was refused");
    return false;
  }
}

void change(VoxelMap& map, std::set<Voxel>& full, fuzz::ByteShapes& bytes) {
  const int kind = bytes.byte();
  const bool is_added = kind % 4 != 3;
  const Voxel first = voxel_of(bytes);
  if (kind / 4 % 2 == 0) {
    const std::vector<Voxel> some{first, voxel_of(bytes)};
    const bool is_good = is_of(map.grid(), some[0]) && is_of(map.grid(), some[1]);
    if (!is_taken(is_good, [&] { is_added ? map.add(some) : map.remove(some); })) return;
    for (const Voxel& voxel : some)
      is_added ? void(full.insert(voxel)) : void(full.erase(voxel));
    return;
  }
  const auto size = [&] { return static_cast<std::uint16_t>(bytes.byte() % 6); };
  const auto end = [&](std::uint16_t from) {
    return static_cast<std::uint16_t>(from + size() - 1);
  };
  const std::uint16_t i = end(first.i), j = end(first.j);
  const Voxel last{i, j, end(first.k)};
  const bool is_good = is_of(map.grid(), first) && is_of(map.grid(), last) && first.i <= last.i &&
                       first.j <= last.j && first.k <= last.k;
  if (!is_taken(is_good,
                [&] { is_added ? map.add_block(first, last) : map.remove_block(first, last); }))
    return;
  for (std::uint16_t z = first.k; z <= last.k; ++z)
    for (std::uint16_t y = first.j; y <= last.j; ++y)
      for (std::uint16_t x = first.i; x <= last.i; ++x)
        is_added ? void(full.insert({x, y, z})) : void(full.erase({x, y, z}));
}

void check(const VoxelMap& map, const std::set<Voxel>& full, const Voxel& any) {
  fail_if(map.voxels() != std::vector<Voxel>(full.begin(), full.end()), "other voxels");
  fail_if(map.size() != full.size(), "another size");
  fail_if(map.contains(any) != full.contains(any), "another answer to whether a voxel is full");
  for (const Voxel& voxel : full)
    fail_if(map.voxel(map.part(voxel)) != voxel, "a number of another voxel");
}

/// A world with the map, and one with a compound of its boxes.
struct Scenes {
  World of_map, of_boxes;
  std::vector<std::uint32_t> numbers;  ///< of the map, by those of the compound
  Shape box = Sphere{{0, 0, 0}, 1};    ///< around all of it
  Pose pose;
};

bool fill(Scenes& scenes, const VoxelMap& map, const Pose& pose) {
  for (const Voxel& voxel : map.voxels())
    scenes.numbers.push_back(map.part(voxel));
  std::sort(scenes.numbers.begin(), scenes.numbers.end());
  int refused = 0;
  try {
    Compound boxes;
    for (const std::uint32_t number : scenes.numbers)
      boxes.add({map.box(), map.pose(number)});
    scenes.of_boxes.add({share(boxes), pose}, {.kind = BodyKind::Static});
  } catch (const Error&) {
    ++refused;
  }
  try {
    scenes.of_map.add({share(map), pose}, {.kind = BodyKind::Static});
  } catch (const Error&) {
    ++refused;
  }
  const Aabb own = share(map)->bounds(Pose::Identity());
  scenes.box = Box{own.min.cwiseAbs().cwiseMax(own.max.cwiseAbs())};
  scenes.pose = pose;
  // Where all is near the largest length the one may reach beyond it by what boxes are rounded.
  return refused == 0;
}

void ask(Scenes& scenes, const PlacedShapeView& shape, const Ray& ray) {
  const auto of_map = [&](auto answer) {
    if (answer) answer->part = scenes.numbers[answer->part];
    return answer;
  };
  fail_if(scenes.of_map.find_touching(shape) != scenes.of_boxes.find_touching(shape),
          "another yes or no");
  const auto nearest = of_map(scenes.of_boxes.find_closest(shape));
  const auto found = scenes.of_map.find_closest(shape);
  fail_if(found.has_value() != nearest.has_value(), "one of both is near");
  if (found && nearest->distance.status == PairStatus::Converged && fuzz::is_ordinary(shape) &&
      fuzz::is_ordinary({scenes.box, scenes.pose}))
    fail_if(!(*found == *nearest), "another nearest voxel");
  fail_if(!(scenes.of_map.cast_ray(ray) == of_map(scenes.of_boxes.cast_ray(ray))),
          "another hit of a ray");
  scenes.of_map.add({shape.shape, shape.pose}, {.margin = 0.03125});
  scenes.of_boxes.add({shape.shape, shape.pose}, {.margin = 0.03125});
  const WorldUpdate update = scenes.of_map.update(), wanted = scenes.of_boxes.update();
  fail_if(update.contacts.size() != wanted.contacts.size(), "other contacts");
  for (std::size_t i = 0; i < update.contacts.size(); ++i) {
    BodyContact contact = wanted.contacts[i];
    contact.manifold.set_parts(scenes.numbers[contact.manifold.part_a()], 0);
    fail_if(!(update.contacts[i] == contact), "other contacts");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::ByteShapes bytes(data, size);
  try {
    VoxelMap map(grid_of(bytes));
    std::set<Voxel> full;
    for (int changes = bytes.byte() % 24; changes > 0 && !bytes.is_empty(); --changes)
      change(map, full, bytes);
    check(map, full, voxel_of(bytes));
    if (full.size() > kMostFull) return 0;
    const Pose pose = bytes.pose();
    Scenes scenes;
    if (!fill(scenes, map, pose)) return 0;
    const Shape shape = fuzz::shape(bytes);
    const Pose at = bytes.pose();
    const Triangle t = bytes.triangle();
    ask(scenes, {shape, at}, {t.a, t.b - t.a});
  } catch (const Error&) {
    // A grid, a pose, a shape or a ray that is none, or no voxels.
  }
  return 0;
}
