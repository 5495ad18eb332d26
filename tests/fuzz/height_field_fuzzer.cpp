#include <graze/bvh/error.h>
#include <graze/engine/world/height_field.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_cast.h>
#include <graze/engine/world/shape_motion.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shape_ray.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

#include "tests/fuzz/byte_bodies.h"

// Height fields of any numbers, parts of them replaced, and each question beside the same about
// mesh(). Bad input must be refused by a typed error, and the field must say what a field of the
// same heights says that was made at once.

using namespace graze;
using fuzz::fail_if;

namespace {

/// What a field is made of, as far as it can be right.
struct Parts {
  std::uint32_t columns, rows;
  std::vector<float> heights;
  std::vector<std::uint8_t> holes, materials;
  HeightFieldSettings settings;

  HeightField field() const {
    HeightFieldSettings all = settings;
    all.holes = holes, all.materials = materials;
    return HeightField(columns, rows, std::span<const float>(heights), all);
  }
  HeightField short_field() const {
    HeightFieldSettings all = settings;
    all.holes = holes, all.materials = materials;
    std::vector<std::uint16_t> shorts;
    for (const float height : heights)
      shorts.push_back(static_cast<std::uint16_t>(height));
    return HeightField(columns, rows, std::span<const std::uint16_t>(shorts), all);
  }
};

/// Any float, or a small number.
float height(fuzz::ByteShapes& bytes) {
  const int choice = bytes.byte();
  if (choice % 16 != 15) return static_cast<float>(choice % 8) * 0.25F;
  std::uint32_t bits = 0;
  for (int i = 0; i < 4; ++i)
    bits = bits << 8 | bytes.byte();
  return std::bit_cast<float>(bits);
}

Parts parts_of(fuzz::ByteShapes& bytes) {
  Parts parts{};
  const int kind = bytes.byte();
  parts.columns = bytes.byte() % 12, parts.rows = bytes.byte() % 12;
  if (kind % 8 != 0) parts.columns += 2, parts.rows += 2;
  parts.settings = {.spacing_x = fuzz::length(bytes),
                    .spacing_y = fuzz::length(bytes),
                    .height_scale = fuzz::length(bytes),
                    .height_offset = kind % 2 == 0 ? 0 : bytes.coordinate()};
  const std::size_t count = std::size_t{parts.columns} * parts.rows + (kind == 8);
  for (std::size_t i = 0; i < count; ++i)
    parts.heights.push_back(height(bytes));
  const std::size_t cells = parts.columns < 2 || parts.rows < 2
                                ? 0
                                : std::size_t{parts.columns - 1} * (parts.rows - 1) + (kind == 16);
  if (kind % 3 == 1) {
    for (std::size_t i = 0; i < cells; ++i)
      parts.holes.push_back(bytes.byte() % 4 == 3);
  }
  if (kind % 5 == 1) {
    for (std::size_t i = 0; i < cells; ++i)
      parts.materials.push_back(bytes.byte());
  }
  return parts;
}

/// Of each triangle.
std::vector<std::uint16_t> materials_of(const HeightField& field) {
  std::vector<std::uint16_t> materials;
  for (std::uint32_t r = 0; r + 1 < field.rows(); ++r)
    for (std::uint32_t c = 0; c + 1 < field.columns(); ++c)
      if (!field.is_hole(c, r)) materials.insert(materials.end(), 2, field.material(c, r));
  return materials;
}

bool are_same(const HeightField& s, const HeightField& t) {
  const Mesh a = s.mesh(), b = t.mesh();
  return s.bounds().min == t.bounds().min && s.bounds().max == t.bounds().max &&
         std::equal(a.vertices().begin(), a.vertices().end(), b.vertices().begin(),
                    b.vertices().end()) &&
         std::equal(a.triangles().begin(), a.triangles().end(), b.triangles().begin(),
                    b.triangles().end()) &&
         materials_of(s) == materials_of(t);
}

/// Other heights in a part of it, as with_heights() says and as a field made anew has it.
HeightField patched(const HeightField& field, Parts& parts, fuzz::ByteShapes& bytes) {
  const FieldRange range{bytes.byte() % 16u, bytes.byte() % 16u, bytes.byte() % 8u,
                         bytes.byte() % 8u};
  std::vector<float> heights(std::size_t{range.columns} * range.rows + (bytes.byte() == 255));
  for (float& each : heights)
    each = height(bytes);
  const bool is_part = range.columns > 0 && range.rows > 0 &&
                       range.first_column + range.columns <= parts.columns &&
                       range.first_row + range.rows <= parts.rows &&
                       heights.size() == std::size_t{range.columns} * range.rows;
  Parts next = parts;
  if (is_part) {
    for (std::uint32_t r = 0; r < range.rows; ++r)
      for (std::uint32_t c = 0; c < range.columns; ++c)
        next.heights[(range.first_row + r) * parts.columns + range.first_column + c] =
            heights[r * range.columns + c];
  }
  std::optional<HeightField> anew;
  try {
    anew = next.field();
  } catch (const InputError&) {
  }
  try {
    const HeightField other = field.with_heights(range, std::span<const float>(heights));
    fail_if(!is_part, "a part that is none was replaced");
    fail_if(!anew, "with_heights() takes what the constructor refuses");
    fail_if(!are_same(other, *anew), "with_heights() makes another field");
    parts = next;
    return other;
  } catch (const InputError&) {
    fail_if(is_part && anew, "with_heights() refuses what the constructor takes");
  }
  return field;
}

Mesh with_materials(const HeightField& field) {
  const Mesh bare = field.mesh();
  return Mesh(bare.vertices(), bare.triangles(), materials_of(field));
}

/// A field and its mesh, of which the numbers of triangles are known, in a pose.
class Beside {
 public:
  Beside(const HeightField& field, const Pose& pose)
      : field_(field), mesh_(with_materials(field)), pose_(pose) {
    for (std::uint32_t r = 0; r + 1 < field.rows(); ++r)
      for (std::uint32_t c = 0; c + 1 < field.columns(); ++c)
        for (const std::uint32_t half : {0u, 1u})
          if (!field.is_hole(c, r)) numbers_.push_back(2 * (r * (field.columns() - 1) + c) + half);
  }

  /// What `question(placed field)` and that of the mesh say, or none if both throw.
  template <typename Question>
  auto ask(const Question& question) const {
    using Answer = decltype(question(PlacedShapeView{field_, pose_}));
    std::optional<Answer> of_field, of_mesh;
    try {
      of_mesh = question(PlacedShapeView{mesh_, pose_});
    } catch (const Error&) {
    }
    try {
      of_field = question(PlacedShapeView{field_, pose_});
    } catch (const Error&) {
    }
    fail_if(of_field.has_value() != of_mesh.has_value(), "one of field and mesh throws");
    return std::pair(of_field, of_mesh);
  }
  /// The same, which must be equal.
  template <typename Question>
  auto ask_same(const char* what, const Question& question) const {
    auto both = ask(question);
    fail_if(!(both.first == both.second), what);
    return both.first;
  }

  std::uint32_t number(std::uint32_t triangle) const { return numbers_[triangle]; }
  bool is_ordinary() const { return fuzz::is_ordinary({mesh_, pose_}); }
  const Mesh& mesh() const { return *mesh_.as<Mesh>(); }

 private:
  Shape field_, mesh_;
  const Pose& pose_;
  std::vector<std::uint32_t> numbers_;
};

void ask_distance(const Beside& beside, const PlacedShapeView& shape) {
  auto [found, wanted] = beside.ask([&](const PlacedShapeView& of) { return distance(of, shape); });
  if (!found) return;
  const bool is_any_pair = shape.shape.kind() == ShapeKind::Mesh && wanted->distance == 0;
  if (shape.shape.kind() == ShapeKind::HalfSpace || is_any_pair) {
    fail_if(found->distance != wanted->distance, "another distance");
    return;
  }
  fail_if(!(found->lower_bound <= found->distance), "a bound above the distance");
  found->lower_bound = wanted->lower_bound;
  if (found->status == PairStatus::Converged && wanted->status == PairStatus::Converged)
    fail_if(!(*found == *wanted), "another distance");
}

void ask_ray(const Beside& beside, const Ray& ray) {
  beside.ask_same("another hit of a ray", [&](const PlacedShapeView& of) {
    auto hit = cast_ray(of, ray);
    if (hit && of.shape.kind() == ShapeKind::Mesh) hit->triangle = beside.number(hit->triangle);
    return hit;
  });
}

/// Where no hole changes what features are called.
void ask_contacts(const Beside& beside, const PlacedShapeView& shape, double margin) {
  const auto [found, wanted] = beside.ask([&](const PlacedShapeView& of) {
    return find_contacts(of, shape, ManifoldSettings{.margin = margin});
  });
  if (!found) return;
  fail_if(found->size() != wanted->size(), "other contacts");
  for (std::size_t i = 0; i < found->size(); ++i) {
    ShapeContact of_mesh = (*wanted)[i];
    of_mesh.feature = (*found)[i].feature;
    fail_if(!((*found)[i] == of_mesh), "other contacts");
  }
}

void ask_motion(const Beside& beside, const Pose& pose, const PlacedShapeView& shape,
                fuzz::ByteShapes& bytes) {
  const Triangle t = bytes.triangle();
  const double angle = bytes.byte() * 0x1p-6;
  const auto ask = [&](const PlacedShapeView& of) {
    const RigidMotion motion(shape.pose,
                             {.centre = t.a, .shift = t.b, .axis = t.c, .angle = angle});
    RigidContact contact = first_contact({of.shape, RigidMotion(pose)}, {shape.shape, motion},
                                         {.tolerance = 0x1p-12, .budget = 1 << 10});
    return contact;
  };
  const auto [found, wanted] = beside.ask(ask);
  if (found && !found->is_out_of_budget && !wanted->is_out_of_budget)
    fail_if(!(*found == *wanted), "another first contact");
  const ShapeKind kind = shape.shape.kind();
  if (kind != ShapeKind::Sphere && kind != ShapeKind::Box) return;
  beside.ask_same("another cast", [&](const PlacedShapeView& of) { return cast(of, shape, t.b); });
}

/// Cells that are no slivers: contacts of others are not promised.
bool are_cells_ordinary(const Parts& parts) {
  const auto [least, most] = std::minmax_element(parts.heights.begin(), parts.heights.end());
  const double spacing = std::min(parts.settings.spacing_x, parts.settings.spacing_y);
  const double wide = std::max(parts.settings.spacing_x, parts.settings.spacing_y);
  const double high = (double{*most} - double{*least}) * parts.settings.height_scale;
  return spacing > 1e-3 && wide < 1e3 && high < 1e3 && std::abs(parts.settings.height_offset) < 1e3;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::ByteShapes bytes(data, size);
  try {
    Parts parts = parts_of(bytes);
    HeightField field = parts.field();
    const bool is_whole = std::all_of(parts.heights.begin(), parts.heights.end(), [](float each) {
      return each >= 0 && each < 0x1p16F && each == std::floor(each);
    });
    if (is_whole) fail_if(!are_same(parts.short_field(), field), "16 bits make another field");
    for (int patches = bytes.byte() % 3; patches > 0; --patches)
      field = patched(field, parts, bytes);
    const Pose pose = bytes.pose();
    const Beside beside(field, pose);
    beside.ask_same("another box", [](const PlacedShapeView& of) {
      const Aabb box = bounding_aabb(of);
      return std::pair(box.min, box.max);
    });
    for (int i = 0; i < 3 && !bytes.is_empty(); ++i) {
      const Shape shape = fuzz::shape(bytes);
      const Pose at = bytes.pose();
      const PlacedShapeView placed{shape, at};
      beside.ask_same("one of field and mesh meets",
                      [&](const PlacedShapeView& of) { return intersects(of, placed); });
      const Triangle t = bytes.triangle();
      ask_ray(beside, {t.a, t.b - t.a});
      if (!are_cells_ordinary(parts) || !beside.is_ordinary() || !fuzz::is_ordinary(placed))
        continue;
      ask_distance(beside, placed);
      ask_contacts(beside, placed, i == 2 ? 0.0625 : 0);
      ask_motion(beside, pose, placed, bytes);
    }
  } catch (const Error&) {
    // Refused at the door: sizes, holes everywhere, poses, shapes.
  }
  return 0;
}
