#include <graze/engine/record/shapes/shape_content.h>

#include <graze/bvh/error.h>
#include <graze/engine/world/fields/field_data.h>
#include <graze/engine/world/shapes/hull_data.h>

#include <string_view>
#include <vector>

namespace graze::record {
namespace {

// Each kind takes at least so many bytes, by which wrong counts are refused.
constexpr std::size_t kPointBytes = 24;

void write_vector(const Eigen::Vector3d& v, ByteWriter& to) {
  for (int i = 0; i < 3; ++i)
    to.real(v[i]);
}

Eigen::Vector3d read_vector(ByteReader& from) {
  Eigen::Vector3d v;
  for (int i = 0; i < 3; ++i)
    v[i] = from.real();
  return v;
}

void write_numbers(std::span<const std::uint8_t> numbers, ByteWriter& to) {
  to.text({reinterpret_cast<const char*>(numbers.data()), numbers.size()});
}

std::vector<std::uint8_t> read_numbers(ByteReader& from) {
  const std::string_view bytes = from.text();
  return {bytes.begin(), bytes.end()};
}

/// Writes points plane by plane: bytes of one place in all numbers are together, which zlib packs
/// better.
void write_points(std::span<const Eigen::Vector3d> points, ByteWriter& to) {
  to.number(points.size());
  for (std::size_t byte = 0; byte < sizeof(double); ++byte) {
    for (const Eigen::Vector3d& point : points) {
      for (int i = 0; i < 3; ++i)
        to.byte(static_cast<std::uint8_t>(std::bit_cast<std::uint64_t>(point[i]) >> 8 * byte));
    }
  }
}

std::vector<Eigen::Vector3d> read_points(ByteReader& from) {
  const std::size_t count = from.count(kPointBytes, "points");
  std::vector<std::uint64_t> words(3 * count, 0);
  for (std::size_t byte = 0; byte < sizeof(double); ++byte) {
    for (std::uint64_t& word : words)
      word |= std::uint64_t{from.byte()} << 8 * byte;
  }
  std::vector<Eigen::Vector3d> points(count);
  for (std::size_t i = 0; i < words.size(); ++i)
    points[i / 3][static_cast<Eigen::Index>(i % 3)] = std::bit_cast<double>(words[i]);
  return points;
}

void write(const Sphere& sphere, ByteWriter& to) {
  write_vector(sphere.centre, to), to.real(sphere.radius);
}
void write(const Box& box, ByteWriter& to) {
  write_vector(box.half_extents, to);
}
void write(const Capsule& capsule, ByteWriter& to) {
  to.real(capsule.radius), to.real(capsule.half_length);
}
void write(const Cylinder& cylinder, ByteWriter& to) {
  to.real(cylinder.radius), to.real(cylinder.half_height);
}
void write(const Cone& cone, ByteWriter& to) {
  to.real(cone.radius), to.real(cone.half_height);
}
void write(const Ellipsoid& ellipsoid, ByteWriter& to) {
  write_vector(ellipsoid.centre, to), write_vector(ellipsoid.semi_axes, to);
}
void write(const HalfSpace& half_space, ByteWriter& to) {
  write_vector(half_space.normal, to), to.real(half_space.offset);
}
void write(const Plane& plane, ByteWriter& to) {
  write_vector(plane.normal, to), to.real(plane.offset);
}

void write(const ConvexHull& hull, ByteWriter& to) {
  std::vector<Eigen::Vector3d> corners;
  for (const narrowphase::Vec3& corner : data_of(hull).exact_corners)
    corners.emplace_back(corner.x, corner.y, corner.z);
  write_points(corners, to);
}

void write(const Mesh& mesh, ByteWriter& to) {
  write_points(mesh.vertices(), to);
  to.number(mesh.triangles().size());
  std::int64_t before = 0;
  for (const TriangleIndices& triangle : mesh.triangles()) {
    for (const std::uint32_t vertex : triangle) {
      to.difference(std::int64_t{vertex} - before);
      before = vertex;
    }
  }
  to.number(mesh.materials().size());
  for (const std::uint16_t material : mesh.materials())
    to.number(material);
}

Mesh read_mesh(ByteReader& from) {
  const std::vector<Eigen::Vector3d> vertices = read_points(from);
  std::vector<TriangleIndices> triangles(from.count(3, "triangles"));
  std::int64_t before = 0;
  for (TriangleIndices& triangle : triangles) {
    for (std::uint32_t& vertex : triangle) {
      const std::int64_t step = from.difference();
      if (step < -before || step >= static_cast<std::int64_t>(vertices.size()) - before)
        from.fail("a triangle's vertex is none of the mesh");
      before += step;
      vertex = static_cast<std::uint32_t>(before);
    }
  }
  std::vector<std::uint16_t> materials(from.count(1, "materials"));
  for (std::uint16_t& material : materials)
    material = static_cast<std::uint16_t>(from.number_up_to(0xffff, "material"));
  return materials.empty() ? Mesh(vertices, triangles) : Mesh(vertices, triangles, materials);
}

/// Writes a height field. Heights as whole numbers have 16 bits each; the others are floats.
void write(const HeightField& field, ByteWriter& to) {
  const HeightFieldData& data = HeightFieldAccess::data(field);
  to.number(data.columns), to.number(data.rows);
  for (const double length :
       {data.spacing_x, data.spacing_y, data.height_scale, data.height_offset})
    to.real(length);
  to.byte(data.has_floats ? 1 : 0);
  std::vector<std::uint8_t> holes, materials;
  bool has_holes = false;
  for (std::uint32_t row = 0; row < data.rows; ++row) {
    for (std::uint32_t column = 0; column < data.columns; ++column) {
      const float height = data.stored(column, row);
      const std::uint32_t bits = data.has_floats ? std::bit_cast<std::uint32_t>(height)
                                                 : static_cast<std::uint32_t>(height);
      for (int shift = 0; shift < (data.has_floats ? 32 : 16); shift += 8)
        to.byte(static_cast<std::uint8_t>(bits >> shift));
      if (column + 1 == data.columns || row + 1 == data.rows) continue;
      holes.push_back(data.is_hole(column, row) ? 1 : 0);
      materials.push_back(data.material(column, row));
      has_holes = has_holes || holes.back() != 0;
    }
  }
  if (!has_holes) holes.clear();
  if (!data.has_materials) materials.clear();
  write_numbers(holes, to), write_numbers(materials, to);
}

template <typename Height>
HeightField read_field(ByteReader& from, std::uint32_t columns, std::uint32_t rows,
                       HeightFieldSettings settings) {
  const std::uint64_t count = std::uint64_t{columns} * rows;
  if (count > from.remaining() / sizeof(Height)) from.fail("fewer heights than columns and rows");
  std::vector<Height> heights(static_cast<std::size_t>(count));
  for (Height& height : heights) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < sizeof(Height); ++k)
      bits |= std::uint32_t{from.byte()} << 8 * k;
    if constexpr (sizeof(Height) == 4) {
      height = std::bit_cast<float>(bits);
    } else {
      height = static_cast<std::uint16_t>(bits);
    }
  }
  const std::vector<std::uint8_t> holes = read_numbers(from), materials = read_numbers(from);
  settings.holes = holes, settings.materials = materials;
  return HeightField(columns, rows, std::span<const Height>(heights), settings);
}

HeightField read_height_field(ByteReader& from) {
  const std::uint32_t columns = from.number_up_to(0xffffffff, "columns");
  const std::uint32_t rows = from.number_up_to(0xffffffff, "rows");
  HeightFieldSettings settings;
  for (double* length :
       {&settings.spacing_x, &settings.spacing_y, &settings.height_scale, &settings.height_offset})
    *length = from.real();
  return from.flags(1, "heights") != 0 ? read_field<float>(from, columns, rows, settings)
                                       : read_field<std::uint16_t>(from, columns, rows, settings);
}

/// Makes a half-space or a plane with the numbers that a shape has had, which it leaves as they
/// are.
template <typename Flat>
Shape as_it_was(const Flat& flat, const ByteReader& from) {
  Shape shape(flat);
  if (shape.as<Flat>()->normal != flat.normal) from.fail("a normal that is not of length 1");
  return shape;
}

}  // namespace

void write_shape(const Shape& shape, ByteWriter& to) {
  to.byte(static_cast<std::uint8_t>(shape.kind()));
  std::visit([&](const auto& value) { write(value, to); }, shape.value());
}

/// Reads a shape. Members in braces are read in the order in which they stand.
Shape read_shape(std::uint8_t kind, ByteReader& from) {
  switch (static_cast<ShapeKind>(kind)) {
    case ShapeKind::Sphere:
      return Sphere{read_vector(from), from.real()};
    case ShapeKind::Box:
      return Box{read_vector(from)};
    case ShapeKind::Capsule:
      return Capsule{from.real(), from.real()};
    case ShapeKind::Cylinder:
      return Cylinder{from.real(), from.real()};
    case ShapeKind::Cone:
      return Cone{from.real(), from.real()};
    case ShapeKind::Ellipsoid:
      return Ellipsoid{read_vector(from), read_vector(from)};
    case ShapeKind::ConvexHull:
      return ConvexHull(read_points(from));
    case ShapeKind::HalfSpace:
      return as_it_was(HalfSpace{read_vector(from), from.real()}, from);
    case ShapeKind::Mesh:
      return read_mesh(from);
    case ShapeKind::HeightField:
      return read_height_field(from);
    case ShapeKind::Plane:
      return as_it_was(Plane{read_vector(from), from.real()}, from);
  }
  from.fail("a shape of an unknown kind");
}

}  // namespace graze::record
