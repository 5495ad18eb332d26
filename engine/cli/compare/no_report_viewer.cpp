#include <graze/engine/cli/compare/report_viewer.h>

namespace graze::cli {

ReportViewer report_viewer(std::span<const WrittenCase>, const std::string&) {
  return {};  // built without pages
}

}  // namespace graze::cli
