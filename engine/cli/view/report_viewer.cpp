#include <graze/engine/cli/compare/report_viewer.h>

#include <graze/engine/cli/view/case_pictures.h>

#include <string>

namespace graze::cli {

ReportViewer report_viewer(std::span<const WrittenCase> cases, const std::string& place) {
  ReportViewer viewer;
  ShownPage page({.title = "Wrong answers"});
  for (const WrittenCase& each : cases) {
    const compare::ShrunkCase& shrunk = each.shrunk;
    ListedCase listed = {.name = shrunk.engine + " in " + place + " " + each.where,
                         .query = shrunk.query};
    listed.query.note = shrunk.engine + " says " + (each.says.empty() ? "nothing" : each.says) +
                        ", the truth is " + shrunk.judgement.truth + ".";
    const std::size_t before = page.frames;
    try {
      show_case(listed, page);
      viewer.first.emplace_back(before);
    } catch (const Error&) {
      viewer.first.emplace_back();  // its numbers are beyond what can be drawn: the report says so
    }
  }
  if (page.frames == 0) return viewer;
  try {
    viewer.page = page.view.page();
  } catch (const Error& error) {  // meshes that are not shrunk may be too large for a page
    return {.note = error.what()};
  }
  return viewer;
}

}  // namespace graze::cli
