#include <graze/engine/mesh/io/ply_header.h>
#include <algorithm>
#include <array>
#include <string>
#include <unordered_set>

namespace graze::mesh_io {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr std::array<TypeName, 16> kTypeNames = {{{"char", PlyType::Int8},
                                                  {"int8", PlyType::Int8},
                                                  {"uchar", PlyType::Uint8},
                                                  {"uint8", PlyType::Uint8},
                                                  {"short", PlyType::Int16},
                                                  {"int16", PlyType::Int16},
                                                  {"ushort", PlyType::Uint16},
                                                  {"uint16", PlyType::Uint16},
                                                  {"int", PlyType::Int32},
                                                  {"int32", PlyType::Int32},
                                                  {"uint", PlyType::Uint32},
                                                  {"uint32", PlyType::Uint32},
                                                  {"float", PlyType::Float32},
                                                  {"float32", PlyType::Float32},
                                                  {"double", PlyType::Float64},
                                                  {"float64", PlyType::Float64}}};

bool is_integer(PlyType type) {
  return type != PlyType::Float32 && type != PlyType::Float64;
}

class PlyHeaderReader {
 public:
  PlyHeaderReader(const Source& source, TextCursor& cursor) : source_(source), cursor_(cursor) {}

  PlyHeader read() {
    if (!cursor_.has_token() || cursor_.token() != "ply") cursor_.fail("expected \"ply\"");
    // A file whose lines end with CR alone may have data that begin with LF.
    const std::string_view rest = source_.bytes.substr(cursor_.offset());
    const bool has_bare_returns = rest.starts_with("\r") && !rest.starts_with("\r\n");
    cursor_.end_line();
    while (read_statement()) {
    }
    if (!has_encoding_) cursor_.fail("the header has no \"format\"");
    if (has_bare_returns) {
      cursor_.end_line_with_return();
    } else {
      cursor_.end_line();
    }
    return std::move(header_);
  }

 private:
  /// Reads a statement. Returns false behind "end_header".
  bool read_statement() {
    if (!cursor_.find_token()) cursor_.fail("expected \"end_header\", but the file ends");
    const Place place = cursor_.place();
    const std::string_view keyword = cursor_.token();
    if (keyword == "end_header") return false;
    if (keyword == "comment" || keyword == "obj_info") {
      cursor_.skip_line();
      return true;
    }
    if (keyword == "format") {
      read_format();
    } else if (keyword == "element") {
      read_element(place);
    } else if (keyword == "property") {
      read_property();
    } else {
      cursor_.fail("unknown header statement " + quoted(keyword));
    }
    cursor_.end_line();
    return true;
  }

  void read_format() {
    if (has_encoding_) cursor_.fail("a second \"format\"");
    has_encoding_ = true;
    const std::string_view name = word("an encoding");
    if (name == "ascii") {
      header_.encoding = PlyEncoding::Ascii;
    } else if (name == "binary_little_endian") {
      header_.encoding = PlyEncoding::BinaryLittleEndian;
    } else if (name == "binary_big_endian") {
      header_.encoding = PlyEncoding::BinaryBigEndian;
    } else {
      cursor_.fail("unknown encoding " + quoted(name));
    }
    const std::string_view version = word("a version");
    if (version != "1.0") cursor_.fail("version " + quoted(version) + " is not supported");
  }

  void read_element(Place place) {
    PlyElement element;
    element.place = place;
    element.name = word("the name of an element");
    const std::int64_t count = cursor_.integer();
    if (count < 0) cursor_.fail("the count " + std::to_string(count) + " is negative");
    element.count = static_cast<std::uint64_t>(count);
    header_.elements.push_back(std::move(element));
  }

  void read_property() {
    if (header_.elements.empty()) cursor_.fail("a property before the first element");
    PlyProperty property{};
    std::string_view type = word("a type");
    if (type == "list") {
      property.count_type = to_type(word("a type"));
      if (!is_integer(*property.count_type)) cursor_.fail("the count of a list must be an integer");
      type = word("a type");
    }
    property.type = to_type(type);
    property.name = word("the name of a property");
    set_role(header_.elements.back(), property);
    header_.elements.back().properties.push_back(property);
  }

  void set_role(const PlyElement& element, PlyProperty& property) const {
    const bool is_list = property.count_type.has_value();
    if (is_list && (property.name == "vertex_indices" || property.name == "vertex_index")) {
      property.role = PlyRole::Corners;
      if (element.name != "face") {
        cursor_.fail("element " + quoted(element.name) +
                     " is not supported, corners are read from element \"face\" alone");
      }
      if (!is_integer(property.type)) cursor_.fail("the corners of a face must be integers");
    } else if (!is_list && element.name == "vertex") {
      if (property.name == "x") property.role = PlyRole::X;
      if (property.name == "y") property.role = PlyRole::Y;
      if (property.name == "z") property.role = PlyRole::Z;
    }
  }

  PlyType to_type(std::string_view name) const {
    const auto found = std::ranges::find(kTypeNames, name, &TypeName::name);
    if (found == kTypeNames.end()) cursor_.fail("unknown type " + quoted(name));
    return found->type;
  }

  std::string_view word(std::string_view wanted) {
    if (!cursor_.has_token())
      cursor_.fail("expected " + std::string(wanted) + ", but the line ends");
    return cursor_.token();
  }

  const Source& source_;
  TextCursor& cursor_;
  PlyHeader header_;
  bool has_encoding_ = false;
};

/// Fails unless exactly one property of the element has the role.
void require_one(const Source& source, const PlyElement& element, PlyRole role,
                 std::string_view name) {
  const auto count = std::ranges::count(element.properties, role, &PlyProperty::role);
  if (count == 1) return;
  fail(source, element.place,
       "element " + quoted(element.name) + " has " + (count == 0 ? "no " : "more than one ") +
           std::string(name));
}

void check_element(const Source& source, const PlyElement& element) {
  if (element.count == 0) return;
  if (element.name == "vertex") {
    require_one(source, element, PlyRole::X, "property x");
    require_one(source, element, PlyRole::Y, "property y");
    require_one(source, element, PlyRole::Z, "property z");
  } else if (element.name == "face") {
    require_one(source, element, PlyRole::Corners, "list vertex_indices or vertex_index");
  }
}

void check_elements(const Source& source, const PlyHeader& header) {
  std::unordered_set<std::string_view> names;
  for (const PlyElement& element : header.elements) {
    if (!names.insert(element.name).second) {
      fail(source, element.place, "a second element " + quoted(element.name));
    }
    check_element(source, element);
  }
}

}  // namespace

std::size_t size_of(PlyType type) {
  constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

PlyHeader read_ply_header(const Source& source, TextCursor& cursor) {
  PlyHeader header = PlyHeaderReader(source, cursor).read();
  check_elements(source, header);
  return header;
}

}  // namespace graze::mesh_io
