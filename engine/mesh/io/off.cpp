#include <graze/engine/mesh/io/readers.h>
#include <graze/engine/mesh/io/text_cursor.h>
#include <algorithm>
#include <string>

namespace graze::mesh_io {
namespace {

// The fewest bytes of a vertex and of a face, with the line's end. Claimed counts make room for no
// more than the file can hold.
constexpr std::uint64_t kVertexBytes = 6;
constexpr std::uint64_t kFaceBytes = 8;

struct Counts {
  std::uint64_t vertices;
  std::uint64_t faces;
};

/// Reads "OFF", or the beginning of a token up to it: some writers put the counts right behind.
void read_keyword(TextCursor& cursor) {
  cursor.require_token("\"OFF\"");
  const std::string_view keyword = cursor.token_through("OFF");
  std::string_view prefix = keyword;
  if (!prefix.ends_with("OFF")) cursor.fail("expected \"OFF\", found " + quoted(keyword));
  prefix.remove_suffix(3);
  for (const std::string_view known : {"ST", "C", "N"}) {
    if (prefix.starts_with(known)) prefix.remove_prefix(known.size());
  }
  if (prefix == "4" || prefix == "n" || prefix == "4n") {
    cursor.fail("vertices that are not in three dimensions (" + quoted(keyword) +
                ") are not supported");
  }
  if (!prefix.empty()) cursor.fail("expected \"OFF\", found " + quoted(keyword));
  if (cursor.peek() == "BINARY") cursor.fail("binary OFF is not supported");
}

std::uint64_t read_count(TextCursor& cursor) {
  const std::int64_t count = cursor.integer();
  if (count < 0) cursor.fail("the count " + std::to_string(count) + " is negative");
  return static_cast<std::uint64_t>(count);
}

/// Reads the counts of vertices, faces and edges; the last, which nothing depends on, may be
/// missing.
Counts read_counts(TextCursor& cursor) {
  cursor.require_token("the counts of vertices and faces");
  Counts counts{};
  counts.vertices = read_count(cursor);
  counts.faces = read_count(cursor);
  if (cursor.has_token()) read_count(cursor);
  cursor.end_line();
  return counts;
}

/// Goes to the next vertex or face; the message counts those that the file has.
void require_row(TextCursor& cursor, std::uint64_t done, std::uint64_t claimed, const char* what) {
  if (cursor.find_token()) return;
  cursor.fail("the file ends after " + std::to_string(done) + " of " + std::to_string(claimed) +
              " " + what);
}

void read_vertices(TextCursor& cursor, std::uint64_t count, MeshBuilder& builder) {
  builder.reserve_vertices(std::min(count, cursor.remaining() / kVertexBytes + 1));
  for (std::uint64_t i = 0; i < count; ++i) {
    require_row(cursor, i, count, "vertices");
    const double x = cursor.number();
    const double y = cursor.number();
    const double z = cursor.number();
    cursor.skip_line();
    builder.add_vertex(x, y, z);
  }
}

void read_face(TextCursor& cursor, MeshBuilder& builder) {
  const Place place = cursor.place();
  const std::uint64_t corners = read_count(cursor);
  builder.begin_polygon();
  for (std::uint64_t i = 0; i < corners; ++i)
    builder.add_corner(cursor.integer(), place);
  builder.end_polygon(place);
  cursor.skip_line();
}

}  // namespace

MeshArrays read_off(const Source& source, const ReadSettings& settings) {
  TextCursor cursor(source, {.comment = '#'});
  read_keyword(cursor);
  cursor.require_token("the counts of vertices and faces");
  const Counts counts = read_counts(cursor);
  MeshBuilder builder(source, {.total = counts.vertices}, settings);
  read_vertices(cursor, counts.vertices, builder);
  builder.reserve_triangles(std::min(counts.faces, cursor.remaining() / kFaceBytes + 1));
  for (std::uint64_t i = 0; i < counts.faces; ++i) {
    require_row(cursor, i, counts.faces, "faces");
    read_face(cursor, builder);
  }
  if (cursor.find_token())
    cursor.fail("unexpected " + quoted(cursor.token()) + " after the last face");
  return builder.finish();
}

}  // namespace graze::mesh_io
