#include <graze/engine/mesh/io/readers.h>
#include <graze/engine/mesh/io/text_cursor.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <utility>

namespace graze::mesh_io {
namespace {

using namespace std::string_view_literals;

/// Statements that are skipped: attributes, grouping, display, points and lines. They carry nothing
/// that has a surface. Frequent ones come first.
constexpr std::array kSkipped = {
    "vn"sv,       "vt"sv,       "vp"sv,     "usemtl"sv, "g"sv,          "o"sv,         "s"sv,
    "l"sv,        "p"sv,        "mtllib"sv, "mg"sv,     "usemap"sv,     "maplib"sv,    "bevel"sv,
    "c_interp"sv, "d_interp"sv, "lod"sv,    "ctech"sv,  "shadow_obj"sv, "trace_obj"sv, "stech"sv};

/// Statements that are errors: free-form curves and surfaces with what belongs to them, and the
/// patches of older files.
constexpr std::array kUnsupported = {"cstype"sv, "deg"sv,  "bmat"sv, "step"sv, "curv"sv,
                                     "curv2"sv,  "surf"sv, "parm"sv, "trim"sv, "hole"sv,
                                     "scrv"sv,   "sp"sv,   "end"sv,  "con"sv,  "bsp"sv,
                                     "bzp"sv,    "cdc"sv,  "cdp"sv,  "res"sv};

class ObjReader {
 public:
  ObjReader(const Source& source, const ReadSettings& settings)
      : cursor_(source, {.comment = '#', .has_continued_lines = true}),
        builder_(source, {.first = 1}, settings) {}

  MeshArrays read() {
    if (cursor_.find_token()) read_counts();
    while (cursor_.find_token())
      read_statement();
    check_counts();
    return builder_.finish();
  }

 private:
  /// Reads the counts of vertices and faces with which some files begin, those that come with FCL
  /// among them. What they say must be so.
  void read_counts() {
    const std::string_view first = cursor_.peek();
    if (first.find_first_not_of("0123456789") != std::string_view::npos) return;
    const std::int64_t vertices = cursor_.integer();
    counts_ = {vertices, cursor_.integer()};
    cursor_.end_line();
  }

  void check_counts() const {
    if (!counts_) return;
    const auto check = [&](std::int64_t announced, std::size_t count, const char* what) {
      if (announced >= 0 && static_cast<std::uint64_t>(announced) == count) return;
      cursor_.fail("the first line announces " + std::to_string(announced) + " " + what +
                   ", there are " + std::to_string(count));
    };
    check(counts_->first, builder_.vertex_count(), "vertices");
    check(counts_->second, faces_, "faces");
  }

  void read_statement() {
    const Place place = cursor_.place();
    const std::string_view keyword = cursor_.token();
    if (keyword == "v") {
      read_vertex();
    } else if (keyword == "f" || keyword == "fo") {  // fo is the first version's word for a face
      read_face(place);
    } else if (std::ranges::find(kSkipped, keyword) != kSkipped.end()) {
      cursor_.skip_line();
    } else if (std::ranges::find(kUnsupported, keyword) != kUnsupported.end()) {
      cursor_.fail("free-form statement " + quoted(keyword) + " is not supported");
    } else if (keyword == "call" || keyword == "csh") {
      cursor_.fail("statement " + quoted(keyword) +
                   " goes outside the file, which is not supported");
    } else {
      cursor_.fail("unknown statement " + quoted(keyword));
    }
  }

  void read_vertex() {
    const double x = cursor_.number();
    const double y = cursor_.number();
    const double z = cursor_.number();
    // This is a weight, which only free-form geometry uses, or a colour. A lost line break must not
    // pass.
    while (cursor_.has_token())
      cursor_.number();
    cursor_.end_line();
    builder_.add_vertex(x, y, z);
  }

  void read_face(Place place) {
    ++faces_;
    builder_.begin_polygon();
    while (cursor_.has_token())
      read_corner();
    builder_.end_polygon(place);
    cursor_.end_line();
  }

  void read_corner() {
    const Place place = cursor_.place();
    const std::string_view token = cursor_.token();
    const char* end = token.data() + token.size();
    const bool has_plus = token.starts_with('+') && !token.starts_with("+-");
    const char* begin = token.data() + (has_plus ? 1 : 0);
    std::int64_t index = 0;
    const auto result = std::from_chars(begin, end, index);
    if (result.ec != std::errc() || !is_corner_rest({result.ptr, end})) {
      cursor_.fail(quoted(token) + " is not a corner of a face");
    }
    builder_.add_corner(index < 0 ? from_end(index) : index, place);
  }

  /// Returns the vertex of an index counted from the end: -1 is the vertex read last.
  std::int64_t from_end(std::int64_t index) const {
    const auto count = static_cast<std::int64_t>(builder_.vertex_count());
    if (index < -count) {
      cursor_.fail("index " + std::to_string(index) + " is out of range, there are " +
                   std::to_string(count) + " vertices so far");
    }
    return count + 1 + index;
  }

  /// True if this is the rest of a corner: the indices of texture coordinate and normal, which are
  /// skipped. It is nothing, /t, //n or /t/n.
  static bool is_corner_rest(std::string_view rest) {
    constexpr int kSlashes = 2;
    if (!rest.empty() && rest.front() != '/') return false;
    const auto is_known = [](char c) { return (c >= '0' && c <= '9') || c == '-' || c == '/'; };
    return std::ranges::all_of(rest, is_known) && std::ranges::count(rest, '/') <= kSlashes;
  }

  TextCursor cursor_;
  MeshBuilder builder_;
  std::optional<std::pair<std::int64_t, std::int64_t>> counts_;
  std::size_t faces_ = 0;
};

}  // namespace

MeshArrays read_obj(const Source& source, const ReadSettings& settings) {
  return ObjReader(source, settings).read();
}

}  // namespace graze::mesh_io
