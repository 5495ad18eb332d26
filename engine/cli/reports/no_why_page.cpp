#include <graze/engine/cli/reports/why_page.h>

#include <graze/engine/cli/output/outcome.h>

namespace graze::cli {
namespace {

constexpr const char* kNoPages = "--view: this command was built without pages";

}  // namespace

std::string why_page(const PlacedMeshView&, const PlacedMeshView&, const std::string&,
                     const std::string&, const Explanation&) {
  throw UsageError(kNoPages);
}

std::string why_page(const Case&, const std::string&, const CaseExplanation&) {
  throw UsageError(kNoPages);
}

}  // namespace graze::cli
