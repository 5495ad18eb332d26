#include <graze/engine/mesh/io/byte_cursor.h>
#include <graze/engine/mesh/io/ply_header.h>
#include <graze/engine/mesh/io/ply_rows.h>
#include <graze/engine/mesh/io/readers.h>
#include <algorithm>
#include <string>

namespace graze::mesh_io {
namespace {

std::uint64_t vertex_count(const PlyHeader& header) {
  const auto found = std::ranges::find(header.elements, "vertex", &PlyElement::name);
  return found == header.elements.end() ? 0 : found->count;
}

/// Reads the elements of a file, from PlyAsciiRows or PlyBinaryRows.
template <typename Rows>
class PlyReader {
 public:
  PlyReader(const Source& source, const ReadSettings& settings, const PlyHeader& header,
            const Rows& rows)
      : header_(header), rows_(rows), builder_(source, {.total = vertex_count(header)}, settings) {}

  MeshArrays read() {
    for (const PlyElement& element : header_.elements) {
      // Without properties there are no rows, whatever the count.
      if (!element.properties.empty()) read_element(element);
    }
    rows_.finish();
    return builder_.finish();
  }

 private:
  void read_element(const PlyElement& element) {
    rows_.begin_element(element);
    const std::uint64_t likely = std::min(element.count, rows_.max_rows(element));
    if (element.name == "vertex") builder_.reserve_vertices(likely);
    if (element.name == "face") builder_.reserve_triangles(likely);
    for (std::uint64_t row = 0; row < element.count; ++row) {
      rows_.begin_row(element, row);
      read_row(element);
      rows_.end_row();
    }
  }

  void read_row(const PlyElement& element) {
    double x = 0, y = 0, z = 0;
    for (const PlyProperty& property : element.properties) {
      if (property.role == PlyRole::X) {
        x = rows_.number(property.type);
      } else if (property.role == PlyRole::Y) {
        y = rows_.number(property.type);
      } else if (property.role == PlyRole::Z) {
        z = rows_.number(property.type);
      } else if (property.role == PlyRole::Corners) {
        read_face(property);
      } else {
        rows_.skip(property.type, property.count_type ? read_count(property) : 1);
      }
    }
    if (element.name == "vertex") builder_.add_vertex(x, y, z);
  }

  void read_face(const PlyProperty& property) {
    const Place place = rows_.place();
    builder_.begin_polygon();
    for (std::uint64_t left = read_count(property); left > 0; --left) {
      const Place corner = rows_.place();
      builder_.add_corner(rows_.integer(property.type), corner);
    }
    builder_.end_polygon(place);
  }

  std::uint64_t read_count(const PlyProperty& property) {
    const std::int64_t count = rows_.integer(*property.count_type);
    if (count < 0) rows_.fail("the count " + std::to_string(count) + " of a list is negative");
    return static_cast<std::uint64_t>(count);
  }

  const PlyHeader& header_;
  Rows rows_;
  MeshBuilder builder_;
};

}  // namespace

MeshArrays read_ply(const Source& source, const ReadSettings& settings) {
  TextCursor cursor(source, {});
  const PlyHeader header = read_ply_header(source, cursor);
  if (header.encoding == PlyEncoding::Ascii) {
    return PlyReader(source, settings, header, PlyAsciiRows(cursor)).read();
  }
  const std::endian order =
      header.encoding == PlyEncoding::BinaryLittleEndian ? std::endian::little : std::endian::big;
  return PlyReader(source, settings, header,
                   PlyBinaryRows(ByteCursor(source, cursor.offset(), order)))
      .read();
}

}  // namespace graze::mesh_io
