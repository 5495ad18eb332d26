// The JSON is written by hand, as in pair_json.cpp: it has numbers only, and the order of the keys
// is promised. They are printed with as many digits as it takes to read the same double again.

#include <graze/engine/cli/reports/contacts_report.h>
#include <graze/engine/cli/reports/table.h>

#include <fmt/format.h>
#include <iterator>
#include <vector>

namespace graze::cli {
std::string vector_json(const Eigen::Vector3d& v) {
  return fmt::format("[{},{},{}]", v.data()[0], v.data()[1], v.data()[2]);
}

namespace {

std::string json_of(const MeshContacts& contacts, const MeshContact& contact, bool is_listing) {
  std::string text = fmt::format(
      "{{\"depth\":{},\"normal\":{},\"point\":{},\"point_a\":{},\"point_b\":{},\"corners\":{}",
      contact.depth, vector_json(contact.normal), vector_json(contact.point),
      vector_json(contact.point_a), vector_json(contact.point_b), contact.point_count);
  if (!is_listing) return text + "}";
  text += ",\"list\":[";
  const char* separator = "";
  for (const Eigen::Vector3d& point : contacts.points_of(contact)) {
    text += separator;
    text += vector_json(point);
    separator = ",";
  }
  return text + "]}";
}

std::string row_number(double value) {
  return fmt::format("{:.6g}", value);
}

}  // namespace

std::string to_json(const ContactsAnswer& answer) {
  const MeshContacts& contacts = answer.contacts;
  std::string line = "{\"contacts\":[";
  const char* separator = "";
  for (const MeshContact& contact : contacts) {
    line += separator;
    line += json_of(contacts, contact, answer.is_listing);
    separator = ",";
  }
  const auto end = std::back_inserter(line);
  fmt::format_to(end, "],\"complete\":{}", contacts.completeness == Completeness::Complete);
  if (answer.separation) {
    fmt::format_to(end, ",\"separation\":{{\"distance\":{},\"translation\":{}}}",
                   answer.separation->distance, vector_json(answer.separation->translation));
  }
  fmt::format_to(end,
                 ",\"work\":{{\"volume_tests\":{},\"volume_rejections\":{},\"filter_tests\":{},"
                 "\"triangle_tests\":{},\"exact_tests\":{},\"trees_built\":{},\"skins_built\":{}}}",
                 answer.work.volume_tests, answer.work.volume_rejections, answer.work.filter_tests,
                 answer.work.triangle_tests, answer.work.exact_tests, answer.work.trees_built,
                 answer.work.skins_built);
  return line + "}\n";
}

std::string to_text(const ContactsAnswer& answer) {
  const MeshContacts& contacts = answer.contacts;
  if (contacts.empty() && contacts.completeness == Completeness::Complete)
    return "the surfaces do not meet\n";
  const std::size_t width = 12;
  const Table table({{"depth, m", width},
                     {"normal x", width},
                     {"y", width},
                     {"z", width},
                     {"point x, m", width},
                     {"y", width},
                     {"z", width},
                     {"corners", 7}});
  std::string text = table.header();
  for (const MeshContact& contact : contacts) {
    std::vector<std::string> row = {row_number(contact.depth)};
    for (const Eigen::Vector3d& v : {contact.normal, contact.point}) {
      for (int k = 0; k < 3; ++k)
        row.push_back(row_number(v.data()[k]));
    }
    row.push_back(fmt::format("{}", contact.point_count));
    text += table.row(row);
    if (!answer.is_listing) continue;
    for (const Eigen::Vector3d& p : contacts.points_of(contact))
      text += fmt::format("  {} {} {}\n", p.data()[0], p.data()[1], p.data()[2]);
  }
  if (contacts.completeness == Completeness::LimitReached)
    text += "there are more, none of them deeper\n";
  if (answer.separation) {
    const double* t = answer.separation->translation.data();
    text += fmt::format("apart when B moves {:.9g} m, by ({}, {}, {})\n",
                        answer.separation->distance, t[0], t[1], t[2]);
  }
  return text;
}

}  // namespace graze::cli
