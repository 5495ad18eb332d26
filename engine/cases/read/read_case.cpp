#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/cases/read/read_parts.h>
#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/text/case_words.h>
#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/file_bytes.h>

#include <limits>

namespace graze {
namespace {

using cases::JsonCursor;

Ask read_question(const JsonCursor& at) {
  std::string list;
  for (const auto& [name, ask] : cases::kAsks) {
    if (at.text() == name) return ask;
    list += (list.empty() ? "" : ", ") + std::string(name);
  }
  at.fail("there is no question " + mesh_io::quoted(at.text()) + "; there are " + list);
}

bool is_mesh(const CaseShape& shape) {
  return std::holds_alternative<CaseMesh>(shape);
}

bool is_triangle(const CaseShape& shape) {
  return std::holds_alternative<Triangle>(shape);
}

bool is_body(const CaseShape& shape) {
  return std::holds_alternative<CaseBody>(shape);
}

bool is_volume(const CaseShape& shape) {
  return std::holds_alternative<Aabb>(shape) || std::holds_alternative<Obb>(shape) ||
         std::holds_alternative<Sphere>(shape);
}

bool is_mesh_pair(const Case& query) {
  return is_mesh(query.a) && query.b && is_mesh(*query.b);
}

/// True if the library has such a query.
bool is_answerable(const Case& query) {
  const CaseShape& a = query.a;
  if (!query.b) return is_mesh(a);
  const CaseShape& b = *query.b;
  const bool is_point_b = std::holds_alternative<CasePoint>(b);
  const bool is_ray_b = std::holds_alternative<Ray>(b);
  const bool is_volume_b = is_volume(b);
  switch (query.ask) {
    case Ask::Any:
      return (is_mesh(a) && (is_mesh(b) || is_volume_b)) ||
             (is_triangle(a) && (is_triangle(b) || is_volume_b)) || (is_volume(a) && is_volume_b) ||
             (is_body(a) && is_body(b));
    case Ask::Pairs:
      return is_mesh(a) && (is_mesh(b) || is_volume_b);
    case Ask::Distance:
      return is_mesh_pair(query) || (is_triangle(a) && is_triangle(b)) ||
             (is_body(a) && is_body(b));
    case Ask::Within:
    case Ask::Contacts:
    case Ask::FirstContact:
    case Ask::Free:
      return is_mesh_pair(query) || (is_body(a) && is_body(b));
    case Ask::Intersection:
      return is_mesh_pair(query) || (is_triangle(a) && is_triangle(b));
    case Ask::Separation:
      return is_mesh_pair(query) || (is_body(a) && is_body(b) && !query.settings.direction);
    case Ask::Ray:
      return (is_mesh(a) || is_triangle(a) || is_body(a)) && is_ray_b;
    case Ask::RayAll:
      return is_mesh(a) && is_ray_b;
    case Ask::Contains:
      return (is_mesh(a) || is_volume(a)) && is_point_b;
    default:
      return false;
  }
}

/// Reads a name, which is printed: nothing in it may move the cursor of a terminal. In UTF-8 the
/// control characters are the bytes below space, 0x7f, and 0x80 to 0x9f behind 0xc2.
std::string read_name(const JsonCursor& at) {
  constexpr std::size_t kMaxName = 128;
  const std::string& name = at.text();
  if (name.size() > kMaxName) {
    at.fail("is a name of " + std::to_string(name.size()) + " bytes, more than " +
            std::to_string(kMaxName));
  }
  unsigned before = 0;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_high = before == 0xc2 && byte <= 0x9f;
    if (byte < 0x20 || byte == 0x7f || is_high) at.fail("is a name with a control character");
    before = byte;
  }
  return name;
}

CaseWitness read_witness(const JsonCursor& at) {
  at.require_keys({"engine", "version"});
  return {read_name(at.member("engine")), at.has("version") ? read_name(at.member("version")) : ""};
}

/// Refuses pairs of the answer beyond the meshes, which would be found nowhere.
void check_pairs(const JsonCursor& root, const Case& query) {
  if (!query.answer) return;
  const auto count = [](const CaseShape& shape) -> std::size_t {
    if (is_mesh(shape)) return std::get<CaseMesh>(shape).mesh.triangles().size();
    const Mesh* body = is_body(shape) ? std::get<CaseBody>(shape).shape.as<Mesh>() : nullptr;
    return body != nullptr ? body->triangles().size() : 1;
  };
  const std::size_t count_a = count(query.a);
  const std::size_t count_b = query.b ? count(*query.b) : count_a;
  const auto check = [&](const TrianglePair& pair) {
    if (pair.a < count_a && pair.b < count_b) return;
    root.member("answer").fail("there is no pair of triangles " + std::to_string(pair.a) + " and " +
                               std::to_string(pair.b));
  };
  const CaseAnswer& answer = *query.answer;
  const auto check_all = [&](const std::vector<TrianglePair>& pairs) {
    for (const TrianglePair& pair : pairs)
      check(pair);
  };
  if (answer.pair) check(*answer.pair);
  if (answer.pairs) check_all(*answer.pairs);
  if (answer.triangles && !answer.triangles->empty()) check({answer.triangles->back(), 0});
  if (answer.intersection) cases::for_each_pairs(*answer.intersection, check_all);
  if (!answer.hits) return;
  for (const RayHit& hit : *answer.hits) {
    if (hit.triangle == kNoTriangle || hit.triangle < count_a) continue;
    root.member("answer").fail("there is no triangle " + std::to_string(hit.triangle));
  }
}

std::string place_of(const std::filesystem::path& path) {
  return mesh_io::printable(path.string());
}

}  // namespace

Case parse_case(std::string_view bytes, const std::string& name, const ReadCaseSettings& settings) {
  return bvh::in_standard_arithmetic([&]() -> Case {
    const cases::JsonValue tree = cases::parse_json(bytes, name);
    const JsonCursor root(tree, name);
    // The version is read first: a later one may have other keys.
    const std::uint32_t version =
        root.member("graze_case").index(std::numeric_limits<std::uint32_t>::max());
    if (version != cases::kCaseVersion) {
      root.member("graze_case")
          .fail("is version " + std::to_string(version) + "; this program reads " +
                std::to_string(cases::kCaseVersion));
    }
    root.require_keys({"graze_case", "note", "origin", "question", "settings", "a", "b", "answer",
                       "answered_by"});
    const Ask ask = read_question(root.member("question"));
    const bool has_b = !cases::is_about_one(ask);
    if (!has_b && root.has("b")) root.member("b").fail("the question is about A alone");
    cases::CaseShapes shapes = read_shapes(root, has_b, settings);
    Case query{.note = root.has("note") ? root.member("note").text() : "",
               .ask = ask,
               .settings = cases::read_settings(root, ask),
               .a = std::move(shapes.a),
               .b = std::move(shapes.b),
               .answer = std::nullopt,
               .answered_by = {}};
    if (root.has("origin")) query.origin = root.member("origin").text();
    if (!is_answerable(query)) {
      root.member("question")
          .fail(std::string("no query answers \"") + name_of(query.ask) + "\" for a " +
                name_of(query.a) + (query.b ? std::string(" and a ") + name_of(*query.b) : ""));
    }
    cases::check_settings(root, query);
    cases::check_motions(root, query);
    if (root.has("answer") != root.has("answered_by")) {
      root.fail("\"answer\" and \"answered_by\" come together");
    }
    if (root.has("answer")) {
      query.answer = cases::read_answer(root.member("answer"), query);
      query.answered_by = read_witness(root.member("answered_by"));
      check_pairs(root, query);
    }
    return query;
  });
}

Case read_case(const std::filesystem::path& path, const ReadCaseSettings& settings) {
  return bvh::in_standard_arithmetic([&]() -> Case {
    const std::string name = place_of(path);
    std::string bytes;
    try {
      mesh_io::require_regular_file(path, name);
      bytes = mesh_io::read_file(path, name);
    } catch (const MeshError& error) {
      throw CaseError(error.what(), error.place());
    }
    ReadCaseSettings here = settings;
    if (here.mesh_folder.empty()) here.mesh_folder = path.parent_path();
    return parse_case(bytes, name, here);
  });
}

}  // namespace graze
