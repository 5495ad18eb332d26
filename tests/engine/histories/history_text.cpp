// A history as text: a line for each operation, of which only what its verb needs is written.

#include <cstdio>
#include <cstdlib>
#include <istream>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "tests/engine/histories/history.h"

namespace graze::tests {
namespace {

enum Field : unsigned {
  kBody = 1,
  kNumber = 2,
  kMotion = 4,
  kFilter = 8,
  kRole = 16,
  kPose = 32,
  kClearance = 64,
  kRay = 128,
  kBox = 256,
  kPart = 512,
  kHasFilter = 1024,
  kVoxels = 2048,
  kEnd = 4096,
  kDetection = 8192
};

struct Word {
  const char* name;
  unsigned parts;
};

constexpr Word kWords[] = {
    {"add", kBody | kNumber | kMotion | kFilter | kRole | kPose},
    {"remove", kBody},
    {"move", kBody | kPose},
    {"move_too", kBody | kPose},
    {"set_shape", kBody | kNumber},
    {"set_filter", kBody | kFilter},
    {"set_motion", kBody | kMotion},
    {"set_role", kBody | kRole},
    {"sleep", kBody},
    {"wake", kBody},
    {"exclude", kBody | kNumber},
    {"include", kBody | kNumber},
    {"filter_pairs", kNumber},
    {"update", 0},
    {"save", 0},
    {"restore", 0},
    {"ask_touching", kNumber | kPose},
    {"ask_within", kNumber | kPose | kClearance},
    {"ask_closest", kNumber | kPose},
    {"ask_ray", kRay},
    {"ask_box", kBox},
    {"add_part", kBody | kNumber | kHasFilter | kFilter | kPose},
    {"replace_part", kBody | kNumber | kPart | kPose},
    {"move_part", kBody | kPart | kPose},
    {"remove_part", kBody | kPart},
    {"set_part", kBody | kNumber | kPart | kHasFilter | kFilter},
    {"fill_voxels", kBody | kVoxels},
    {"clear_voxels", kBody | kVoxels},
    {"ask_closest_pair", 0},
    {"set_margin", kBody | kClearance},
    {"set_detection", kBody | kDetection},
    {"ask_cast", kNumber | kPose | kEnd | kClearance},
};

constexpr const char* kSettingNames[] = {"crowd",  "lattice",   "sizes",    "far",  "one_point",
                                         "skewed", "teleports", "terrains", "parts"};

/// Numbers to or from text: one list of parts for both ways.
template <typename Visit>
void visit_parts(Operation& operation, unsigned parts, const Visit& visit) {
  if ((parts & kBody) != 0) visit(operation.body);
  if ((parts & kNumber) != 0) visit(operation.number);
  if ((parts & kPart) != 0) visit(operation.part);
  if ((parts & kHasFilter) != 0) visit(operation.has_filter);
  if ((parts & kMotion) != 0) visit(operation.settings.kind);
  if ((parts & kFilter) != 0) {
    visit(operation.settings.filter.category);
    visit(operation.settings.filter.mask);
    visit(operation.settings.filter.group);
  }
  if ((parts & kRole) != 0) visit(operation.settings.role);
  if ((parts & kDetection) != 0) visit(operation.settings.detection);
  const auto visit_pose = [&](Pose& pose) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column)
        visit(pose.matrix()(row, column));
    }
  };
  if ((parts & kPose) != 0) visit_pose(operation.pose);
  if ((parts & kEnd) != 0) visit_pose(operation.end);
  const std::size_t values = (parts & kRay) != 0         ? 7
                             : (parts & kBox) != 0       ? 6
                             : (parts & kClearance) != 0 ? 1
                                                         : 0;
  for (std::size_t i = 0; i < values; ++i)
    visit(operation.values[i]);
  if ((parts & kVoxels) != 0) {
    for (std::uint16_t& index : operation.voxels)
      visit(index);
  }
}

void append(std::string& line, double value) {
  char text[40];
  std::snprintf(text, sizeof text, " %a", value);
  line += text;
}

template <typename Number>
void append(std::string& line, Number value) {
  line += ' ' + std::to_string(static_cast<long long>(value));
}

void parse(const std::string& word, double& value) {
  char* end = nullptr;
  value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0') throw std::runtime_error("'" + word + "' is no number");
}

template <typename Number>
void parse(const std::string& word, Number& value) {
  char* end = nullptr;
  value = static_cast<Number>(std::strtoll(word.c_str(), &end, 10));
  if (word.empty() || *end != '\0') throw std::runtime_error("'" + word + "' is no number");
}

Operation parse_operation(const std::string& line) {
  std::istringstream words(line);
  std::string verb;
  words >> verb;
  for (std::size_t i = 0; i < std::size(kWords); ++i) {
    if (verb != kWords[i].name) continue;
    Operation operation;
    operation.verb = static_cast<Verb>(i);
    visit_parts(operation, kWords[i].parts, [&](auto& value) {
      std::string word;
      words >> word;
      parse(word, value);
    });
    std::string rest;
    if (words >> rest) throw std::runtime_error("'" + rest + "' is one word too many");
    return operation;
  }
  throw std::runtime_error("there is no operation '" + verb + "'");
}

}  // namespace

const char* name_of(Setting setting) {
  return kSettingNames[static_cast<std::size_t>(setting)];
}

std::string to_text(const Operation& operation) {
  const Word& word = kWords[static_cast<std::size_t>(operation.verb)];
  std::string line = word.name;
  Operation copy = operation;
  visit_parts(copy, word.parts, [&](auto& value) { append(line, value); });
  return line;
}

void write_history(const History& history, std::ostream& out) {
  out << "graze_history 1 " << name_of(history.setting) << '\n';
  for (const Operation& operation : history.operations)
    out << to_text(operation) << '\n';
}

History read_history(std::istream& in) {
  History history;
  std::string line;
  std::getline(in, line);
  bool is_known = false;
  for (const Setting setting : kSettings) {
    if (line != "graze_history 1 " + std::string(name_of(setting))) continue;
    history.setting = setting;
    is_known = true;
  }
  if (!is_known) throw std::runtime_error("line 1: not a history that this program knows");
  for (int number = 2; std::getline(in, line); ++number) {
    if (line.empty() || line[0] == '#') continue;
    try {
      history.operations.push_back(parse_operation(line));
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("line " + std::to_string(number) + ": " + error.what());
    }
  }
  return history;
}

}  // namespace graze::tests
