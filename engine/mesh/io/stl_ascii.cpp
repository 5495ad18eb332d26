#include <graze/engine/mesh/io/position_index.h>
#include <graze/engine/mesh/io/readers.h>
#include <graze/engine/mesh/io/text_cursor.h>
#include <string>

namespace graze::mesh_io {
namespace {

class StlAsciiReader {
 public:
  StlAsciiReader(const Source& source, const ReadSettings& settings)
      : cursor_(source, {}), settings_(settings) {}

  /// Reads all triangles. Some files hold several solids: the triangles of all count.
  MeshArrays read() {
    do {
      read_solid();
    } while (cursor_.find_token());
    mesh_.vertices = positions_.take_positions();
    return std::move(mesh_);
  }

 private:
  void read_solid() {
    expect("solid");
    cursor_.skip_line();  // this is the name
    while (!is_keyword(next_token("\"facet\" or \"endsolid\""), "endsolid"))
      read_facet();
    cursor_.skip_line();
  }

  /// Reads a facet from behind its first word on, which next_token() has read.
  void read_facet() {
    if (!is_keyword(last_, "facet")) fail_expected("\"facet\" or \"endsolid\"");
    if (settings_.has_places) mesh_.places.push_back(cursor_.place());
    expect("normal");
    // The normal is not parsed: the corners say all, and writers put "nan" here for triangles
    // without area.
    for (int k = 0; k < 3; ++k)
      next_token("a number");
    expect("outer");
    expect("loop");
    TriangleIndices& triangle = mesh_.triangles.emplace_back();
    for (std::uint32_t& corner : triangle)
      corner = read_corner();
    expect("endloop");
    expect("endfacet");
  }

  std::uint32_t read_corner() {
    expect("vertex");
    Eigen::Vector3d position;
    for (int k = 0; k < 3; ++k) {
      cursor_.require_token("a number");
      position[k] = cursor_.number();
    }
    return positions_.add(position);
  }

  std::string_view next_token(std::string_view wanted) {
    cursor_.require_token(wanted);
    last_ = cursor_.token();
    return last_;
  }

  void expect(std::string_view keyword) {
    if (!cursor_.find_token()) cursor_.fail("expected " + quoted(keyword) + ", but the file ends");
    last_ = cursor_.token();
    if (!is_keyword(last_, keyword)) fail_expected(quoted(keyword));
  }

  [[noreturn]] void fail_expected(std::string_view wanted) const {
    cursor_.fail("expected " + std::string(wanted) + ", found " + quoted(last_));
  }

  TextCursor cursor_;
  ReadSettings settings_;
  PositionIndex positions_;
  MeshArrays mesh_;
  std::string_view last_;
};

}  // namespace

MeshArrays read_stl_ascii(const Source& source, const ReadSettings& settings) {
  return StlAsciiReader(source, settings).read();
}

}  // namespace graze::mesh_io
