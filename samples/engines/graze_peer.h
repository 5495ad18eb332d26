// An engine of your own beside graze: copy this page, and say in two functions what it is and what
// it answers. `graze compare A B --engine-command ./yours` asks it, judges it, and names what it
// gets wrong. The protocol is a JSON object a line (engine/compare/peers/process/README.md); this
// page needs nlohmann-json and POSIX alone.

#pragma once

#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace graze_peer {

using Json = nlohmann::json;

struct Mesh {
  std::vector<std::array<double, 3>> vertices;  ///< metres
  std::vector<std::array<std::size_t, 3>> triangles;
};

/// The rows of [R | t], which takes a point of the mesh to R p + t.
using Pose = std::array<double, 12>;

struct Question {
  std::string name;  ///< "any", "pairs", "distance", "within", "contacts"
  Pose pose_a;
  Pose pose_b;
  double clearance = 0;  ///< metres, of "within"
};

/// What an engine throws that knows no such question, or refuses such meshes. That is no error of
/// it; whatever else it throws is one.
struct Unsupported : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The answer as the protocol has it: {{"says", true}}, or {{"distance", 0.25}}.
using Answer = std::function<Json(const Question&)>;

struct Engine {
  std::string name;
  std::string version;
  std::vector<std::string> questions;                                  ///< those that it knows
  std::function<Answer(const Mesh& mesh_a, const Mesh& mesh_b)> load;  ///< builds trees, say
};

inline Mesh read_mesh(const Json& text) {
  return {text.at("vertices"), text.at("triangles")};
}

inline Json reply_to(const Engine& engine, const Json& request, Answer& answer) {
  if (request.contains("load")) {
    const Json& load = request["load"];
    if (!load.contains("a")) throw Unsupported("shapes other than meshes");
    const Mesh a = read_mesh(load["a"]);
    answer = engine.load(a, load.at("b").contains("same_as") ? a : read_mesh(load["b"]));
    return {{"loaded", true}};
  }
  if (!answer) throw std::runtime_error("a question before a load");
  Question question{request.at("question"), request.at("pose_a"), request.at("pose_b")};
  if (request.contains("settings"))
    question.clearance = request["settings"].value("clearance", 0.0);
  const auto start = std::chrono::steady_clock::now();
  const Json said = answer(question);
  const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
  return {{"answer", said}, {"us", time.count()}};
}

/// Answers until there are no more requests. What the engine prints goes to the standard error.
inline int serve(const Engine& engine) {
  std::FILE* replies = fdopen(dup(STDOUT_FILENO), "w");
  if (replies == nullptr || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return 1;
  const auto write = [&](const Json& line) {
    std::fprintf(replies, "%s\n", line.dump().c_str());
    std::fflush(replies);
  };
  write({{"graze_peer", 1},
         {"engine", engine.name},
         {"version", engine.version},
         {"questions", engine.questions}});
  Answer answer;
  for (std::string line; std::getline(std::cin, line);) {
    const Json request = Json::parse(line);
    Json reply;
    try {
      reply = reply_to(engine, request, answer);
    } catch (const Unsupported& why) {
      reply = {{"unsupported", why.what()}};
    } catch (const std::exception& error) {
      reply = {{"error", error.what()}};
    }
    reply["id"] = request.at("id");
    write(reply);
  }
  return 0;
}

}  // namespace graze_peer
