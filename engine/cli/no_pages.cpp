// This stands in for engine/cli/view/ where pages are switched off.

#include <graze/engine/cli/commands/commands.h>
#include <graze/engine/cli/compare/report_viewer.h>
#include <graze/engine/cli/motion/motion_page.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/reports/why_page.h>

namespace graze::cli {
namespace {

constexpr const char* kNoPages = "--view: this command was built without pages";

}  // namespace

void add_view_command(CLI::App&, Action&) {}

ReportViewer report_viewer(std::span<const WrittenCase>, const std::string&) {
  return {};
}

std::unique_ptr<MotionPage> make_motion_page(const Mesh&, const Pose&, const Mesh&,
                                             const MotionPageSettings&) {
  throw UsageError(kNoPages);
}

std::string why_page(const PlacedMeshView&, const PlacedMeshView&, const std::string&,
                     const std::string&, const Explanation&) {
  throw UsageError(kNoPages);
}

std::string why_page(const Case&, const std::string&, const CaseExplanation&) {
  throw UsageError(kNoPages);
}

}  // namespace graze::cli
