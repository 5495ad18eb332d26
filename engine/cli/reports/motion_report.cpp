// Numbers are printed with as many digits as it takes to read the same double again.

#include <graze/engine/cases/case.h>
#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cli/reports/motion_report.h>
#include <graze/engine/cli/reports/table.h>
#include <graze/engine/files/source.h>

#include <fmt/format.h>
#include <iterator>

namespace graze::cli {
namespace {

const Table& table() {
  static const Table kTable({{"motion", 7}, {"answer", 6}, {"free up to t", 18}, {"met at t", 18}});
  return kTable;
}

std::string pose_json(const Pose& pose) {
  std::string numbers;
  for (int i = 0; i < 12; ++i)
    fmt::format_to(std::back_inserter(numbers), "{}{}", i == 0 ? "" : ",",
                   pose.matrix()(i / 4, i % 4));
  return "[" + numbers + "]";
}

}  // namespace

std::string to_json(const MotionAnswer& answer) {
  const RigidContact& contact = answer.contact;
  std::string line = fmt::format(
      "{{\"motion\":{},\"answer\":\"{}\",\"low\":{},\"high\":{},"
      "\"out_of_budget\":{}",
      answer.number, name_of(contact.status), contact.low, contact.high, contact.is_out_of_budget);
  line += ",\"pose_b\":";
  line += contact.status == RigidStatus::Hit ? pose_json(answer.pose_b) : "null";
  if (!answer.certificate.empty())
    line += ",\"certificate\":" + cases::json_string(answer.certificate);
  if (!answer.picture.empty()) line += ",\"picture\":" + cases::json_string(answer.picture);
  fmt::format_to(std::back_inserter(line),
                 ",\"work\":{{\"volume_tests\":{},\"volume_rejections\":{},\"filter_tests\":{},"
                 "\"triangle_tests\":{},\"exact_tests\":{},\"trees_built\":{},\"skins_built\":{}}}",
                 answer.work.volume_tests, answer.work.volume_rejections, answer.work.filter_tests,
                 answer.work.triangle_tests, answer.work.exact_tests, answer.work.trees_built,
                 answer.work.skins_built);
  return line + "}\n";
}

std::string motion_header() {
  return table().header();
}

std::string to_text(const MotionAnswer& answer) {
  const RigidContact& contact = answer.contact;
  const bool is_hit = contact.status == RigidStatus::Hit;
  std::string text =
      table().row({fmt::format("{}", answer.number), name_of(contact.status),
                   fmt::format("{}", contact.low), is_hit ? fmt::format("{}", contact.high) : "-"});
  if (contact.is_out_of_budget) text += "  the budget ended there\n";
  if (!answer.certificate.empty())
    text += "  proof in " + mesh_io::printable(answer.certificate) + "\n";
  if (!answer.picture.empty()) text += "  drawn in " + mesh_io::printable(answer.picture) + "\n";
  return text;
}

}  // namespace graze::cli
