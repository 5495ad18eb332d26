// Numbers are printed with as many digits as it takes to read the same double again.

#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cli/reports/contacts_report.h>
#include <graze/engine/cli/reports/simulate_report.h>
#include <graze/engine/files/source.h>

#include <fmt/format.h>
#include <algorithm>
#include <iterator>
#include <span>
#include <string>

namespace graze::cli {
namespace {

std::string json_of(const Manifold& manifold) {
  std::string out;
  for (const ShapeContact& contact : manifold) {
    out += fmt::format(
        "{}{{\"depth\":{},\"normal\":{},\"point\":{},\"point_a\":{},\"point_b\":{}}}",
        out.empty() ? "" : ",", contact.depth, vector_json(contact.normal),
        vector_json(contact.point), vector_json(contact.point_a), vector_json(contact.point_b));
  }
  return "[" + out + "]";
}

/// Gives the names of a pair of bodies, as a file or a terminal takes them.
struct Names {
  const Scene& scene;

  std::string json(BodyId id) const { return cases::json_string(scene.bodies[id.index].name); }
  std::string json(std::span<const BodyPair> pairs) const {
    std::string out;
    for (const BodyPair& pair : pairs)
      out += fmt::format("{}[{},{}]", out.empty() ? "" : ",", json(pair.a), json(pair.b));
    return "[" + out + "]";
  }
  std::string text(const BodyPair& pair) const {
    return mesh_io::printable(scene.bodies[pair.a.index].name) + " - " +
           mesh_io::printable(scene.bodies[pair.b.index].name);
  }
  /// Gives the names of bodies that may have parts.
  std::string text(const BodyPair& pair, std::uint32_t part_a, std::uint32_t part_b) const {
    return text_of_part(pair.a, part_a) + " - " + text_of_part(pair.b, part_b);
  }
  std::string text_of_part(BodyId id, std::uint32_t part) const {
    const SceneBody& body = scene.bodies[id.index];
    const std::string name = mesh_io::printable(body.name);
    return body.parts.empty() ? name : fmt::format("{}, part {}", name, part);
  }
  /// Gives the two bodies as members of an object, with parts of those that have any.
  std::string members(const BodyPair& pair, std::uint32_t part_a, std::uint32_t part_b) const {
    std::string out = fmt::format("\"a\":{},\"b\":{}", json(pair.a), json(pair.b));
    if (!scene.bodies[pair.a.index].parts.empty()) out += fmt::format(",\"part_a\":{}", part_a);
    if (!scene.bodies[pair.b.index].parts.empty()) out += fmt::format(",\"part_b\":{}", part_b);
    return out;
  }
};

std::string json_of(const WorldWork& work) {
  return fmt::format(
      "{{\"shape_tests\":{},\"pairs_filtered\":{},\"pairs_at_rest\":{},\"pairs_asleep\":{},"
      "\"pairs_apart\":{},\"gaps_measured\":{},\"contacts_found\":{},\"contacts_skipped\":{},"
      "\"pairs_swept\":{},\"trees_built\":{},\"trees_unbuilt\":{},\"convex_failures\":{},"
      "\"penetration_failures\":{}}"
      "}",
      work.shape_tests, work.pairs_filtered, work.pairs_at_rest, work.pairs_asleep,
      work.pairs_apart, work.gaps_measured, work.contacts_found, work.contacts_skipped,
      work.pairs_swept, work.shapes.trees_built, work.trees_unbuilt, work.shapes.convex_failures,
      work.shapes.penetration_failures);
}

}  // namespace

SimulateReport::SimulateReport(Output& output, const Scene& scene,
                               const SimulateReportSettings& settings)
    : output_(output),
      scene_(scene),
      settings_(settings),
      table_({{"step", 6},
              {"time (s)", 10},
              {"begun", 6},
              {"ended", 6},
              {"touching", 8},
              {"tested", 7},
              {"at rest", 7},
              {"too far", 7},
              {"filtered", 8},
              {"contacts", 8},
              {"no tree", 7}}),
      has_swept_bodies_(std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const auto& body) {
        return body.detection == Detection::Continuous;
      })) {}

void SimulateReport::begin() {
  if (!settings_.is_json) output_.write(table_.header());
}

void SimulateReport::add(std::size_t step, double time, const WorldUpdate& update) {
  touching_ += update.begun.size();
  touching_ -= update.ended.size();
  output_.write(settings_.is_json ? json_of(step, time, update) : text_of(step, time, update));
  last_time_ = time;
}

std::string SimulateReport::text_of(std::size_t step, double time,
                                    const WorldUpdate& update) const {
  const Names names{scene_};
  const WorldWork& work = update.work;
  std::string out = table_.row(
      {std::to_string(step), fmt::format("{:.6g}", time), std::to_string(update.begun.size()),
       std::to_string(update.ended.size()), std::to_string(touching_),
       std::to_string(work.shape_tests), std::to_string(work.pairs_at_rest),
       std::to_string(work.pairs_apart), std::to_string(work.pairs_filtered),
       std::to_string(work.contacts_found), std::to_string(work.trees_unbuilt)});
  for (const BodyPair& pair : update.begun)
    out += "  begun: " + names.text(pair) + "\n";
  for (const BodyPair& pair : update.ended)
    out += "  ended: " + names.text(pair) + "\n";
  for (const BodyFirstContact& met : update.first_contacts)
    out += text_of(met, time);
  for (const BodyContact& each : update.contacts) {
    for (const ShapeContact& c : each.manifold) {
      out += fmt::format(
          "  contact: {}: depth {:.6g}, normal ({:.6g}, {:.6g}, {:.6g}), point ({:.6g}, "
          "{:.6g}, {:.6g})\n",
          names.text(each.pair, each.manifold.part_a(), each.manifold.part_b()), c.depth,
          c.normal.x(), c.normal.y(), c.normal.z(), c.point.x(), c.point.y(), c.point.z());
    }
  }
  return out;
}

std::string SimulateReport::text_of(const BodyFirstContact& met, double time) const {
  const Names names{scene_};
  const std::string pair = names.text(met.pair, met.part_a, met.part_b);
  if (met.is_at_start) return "  touched before: " + pair + "\n";
  return fmt::format(
      "  {}: {}: at {:.6g} s, normal ({:.6g}, {:.6g}, {:.6g}), point ({:.6g}, {:.6g}, {:.6g})\n",
      met.contact.status == RigidStatus::Hit ? "met" : "came close", pair, time_of(met, time),
      met.normal.x(), met.normal.y(), met.normal.z(), met.point.x(), met.point.y(), met.point.z());
}

std::string SimulateReport::json_of(const BodyFirstContact& met, double time) const {
  const Names names{scene_};
  return fmt::format(
      "{{{},\"status\":\"{}\",\"time\":{},\"low\":{},\"high\":{},"
      "\"is_out_of_budget\":{},\"is_at_start\":{},\"normal\":{},\"point\":{}}}",
      names.members(met.pair, met.part_a, met.part_b),
      met.contact.status == RigidStatus::Hit ? "hit" : "close", time_of(met, time), met.contact.low,
      met.contact.high, met.contact.is_out_of_budget, met.is_at_start, vector_json(met.normal),
      vector_json(met.point));
}

std::string SimulateReport::json_of(std::size_t step, double time,
                                    const WorldUpdate& update) const {
  const Names names{scene_};
  std::string line =
      fmt::format("{{\"step\":{},\"time\":{},\"begun\":{},\"ended\":{},\"touching\":{}", step, time,
                  names.json(update.begun), names.json(update.ended), touching_);
  if (has_swept_bodies_) {
    line += ",\"first_contacts\":[";
    const char* separator = "";
    for (const BodyFirstContact& met : update.first_contacts) {
      line += separator + json_of(met, time);
      separator = ",";
    }
    line += "]";
  }
  if (settings_.has_contacts) {
    line += ",\"contacts\":[";
    const char* separator = "";
    for (const BodyContact& each : update.contacts) {
      fmt::format_to(std::back_inserter(line), "{}{{{},\"points\":{}}}", separator,
                     names.members(each.pair, each.manifold.part_a(), each.manifold.part_b()),
                     cli::json_of(each.manifold));
      separator = ",";
    }
    line += "]";
  }
  return line + ",\"work\":" + cli::json_of(update.work) + "}\n";
}

}  // namespace graze::cli
