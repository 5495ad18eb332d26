#include <graze/engine/cases/to_case.h>
#include <tests/oracle/case_text.h>

namespace graze::oracle {
namespace {

std::string text_of(const CaseShape& a, const CaseShape& b, bool intersects) {
  Case query = to_case(a, b, intersects);
  query.answered_by = {"referee", ""};
  return to_json(query);
}

}  // namespace

std::string to_text(const TrianglePair& pair, bool intersects) {
  return text_of(pair.a, pair.b, intersects);
}

std::string to_text(const TriangleAndBox& pair, bool intersects) {
  return text_of(pair.triangle, pair.box, intersects);
}

}  // namespace graze::oracle
