#include <graze/engine/cases/read/read_parts.h>
#include <graze/engine/cases/text/case_words.h>
#include <graze/engine/files/source.h>

#include <limits>
#include <string>

namespace graze::cases {
namespace {

/// True for the second and false for the first of two words; any other is refused.
bool is_second(const JsonCursor& at, const char* first, const char* second) {
  if (at.text() != first && at.text() != second) {
    at.fail(mesh_io::quoted(at.text()) + " is neither " + first + " nor " + second);
  }
  return at.text() == second;
}

template <typename Shape>
bool are_both(const Case& query) {
  return std::holds_alternative<Shape>(query.a) && query.b &&
         std::holds_alternative<Shape>(*query.b);
}

bool has_touch(const Case& query) {
  if (query.ask == Ask::Any && are_both<Triangle>(query)) return true;
  return (query.ask == Ask::Any || query.ask == Ask::Pairs) && are_both<CaseMesh>(query);
}

bool has_interior(const Case& query) {
  return query.ask == Ask::Any && std::holds_alternative<CaseMesh>(query.a);
}

void read_lengths(const JsonCursor& at, Ask ask, CaseSettings& settings) {
  if (at.has("clearance")) {
    if (ask != Ask::Within && !is_about_motion(ask)) {
      at.member("clearance")
          .fail("only \"within\", \"first_contact\" and \"free\" have a clearance");
    }
    settings.clearance = read_length(at.member("clearance"));
  }
  if (at.has("tolerance")) {
    if (!is_about_motion(ask)) {
      at.member("tolerance").fail("only \"first_contact\" and \"free\" have a tolerance");
    }
    settings.tolerance = read_length(at.member("tolerance"));
  }
}

}  // namespace

CaseSettings read_settings(const JsonCursor& root, Ask ask) {
  CaseSettings settings;
  if (root.has("settings")) {
    const JsonCursor at = root.member("settings");
    at.require_keys({"touch", "interior", "clearance", "tolerance", "direction", "kind", "limit"});
    if (at.has("touch") && is_second(at.member("touch"), "include", "exclude"))
      settings.hit = Hit::Crossing;
    if (at.has("interior") && is_second(at.member("interior"), "surface", "solid")) {
      if (settings.hit == Hit::Crossing)
        at.member("interior").fail("\"solid\" needs \"touch\" to be \"include\"");
      settings.hit = Hit::Solid;
    }
    read_lengths(at, ask, settings);
    if (at.has("direction")) {
      if (ask != Ask::Separation) {
        at.member("direction").fail("only \"separation\" has a direction");
      }
      settings.direction = at.member("direction").point();
      if (settings.direction->isZero(0)) at.member("direction").fail("is zero");
    }
    if (at.has("kind")) {
      if (ask != Ask::SelfPairs) at.member("kind").fail("only \"self_pairs\" has a kind");
      // Kept cases may still say "crossing" where it is "intersecting" now.
      const bool is_neighbour = at.member("kind").text() != "crossing" &&
                                is_second(at.member("kind"), "intersecting", "neighbour");
      settings.self_kind = is_neighbour ? SelfPairKind::Neighbour : SelfPairKind::Intersecting;
    }
    if (at.has("limit")) {
      if (ask != Ask::Pairs && ask != Ask::SelfPairs) {
        at.member("limit").fail("only \"pairs\" and \"self_pairs\" have a limit");
      }
      settings.limit = at.member("limit").index(std::numeric_limits<std::uint32_t>::max());
    }
  }
  if (ask == Ask::Within && !(root.has("settings") && root.member("settings").has("clearance"))) {
    root.fail("\"within\" needs settings with a clearance");
  }
  return settings;
}

void check_settings(const JsonCursor& root, const Case& query) {
  if (!root.has("settings")) return;
  const JsonCursor at = root.member("settings");
  const CaseSettings& settings = query.settings;
  if (settings.hit == Hit::Crossing && !has_touch(query)) {
    at.member("touch").fail("such a query has no choice but \"include\"");
  }
  if (settings.hit == Hit::Solid && !has_interior(query)) {
    at.member("interior").fail("such a query has no choice but \"surface\"");
  }
}

}  // namespace graze::cases
