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

/// The same about two of the shapes that are loaded, by their numbers; contacts are
/// {{"manifold", {{{"point", p}, {"normal", n}, {"depth", 0.01}}}}}.
using ShapesAnswer = std::function<Json(const Question&, std::size_t shape_a, std::size_t shape_b)>;

struct Engine {
  std::string name;
  std::string version;
  std::vector<std::string> questions;                                  ///< those that it knows
  std::function<Answer(const Mesh& mesh_a, const Mesh& mesh_b)> load;  ///< builds trees, say
  /// Shapes as the protocol has them, {"sphere":{"centre":[0,0,0],"radius":1}}: empty, if the
  /// engine knows none. What it throws Unsupported for it does not know.
  std::function<ShapesAnswer(const std::vector<Json>& shapes)> load_shapes = {};
};

/// What is loaded: meshes or shapes.
struct Loaded {
  Answer meshes;
  ShapesAnswer shapes;
};

inline Mesh read_mesh(const Json& text) {
  return {text.at("vertices"), text.at("triangles")};
}

inline Loaded load(const Engine& engine, const Json& load) {
  if (load.contains("shapes")) {
    if (!engine.load_shapes) throw Unsupported("shapes other than meshes");
    return {{}, engine.load_shapes(load["shapes"])};
  }
  const Mesh a = read_mesh(load.at("a"));
  return {engine.load(a, load.at("b").contains("same_as") ? a : read_mesh(load["b"])), {}};
}

/// Of two bodies one answer, of pairs of bodies whether each meets, or null.
inline Json answer_about_bodies(const ShapesAnswer& answer, const Json& request,
                                Question question) {
  const Json& bodies = request["bodies"];
  const auto ask = [&](std::size_t a, std::size_t b) {
    if (bodies[a].contains("motion") || bodies[b].contains("motion"))
      throw Unsupported("bodies in motion");
    question.pose_a = bodies[a].at("pose");
    question.pose_b = bodies[b].at("pose");
    return answer(question, bodies[a].at("shape"), bodies[b].at("shape"));
  };
  if (!request.contains("pairs")) return {{"answer", ask(0, 1)}};
  Json answers = Json::array();
  for (const Json& pair : request["pairs"]) {
    try {
      answers.push_back(ask(pair[0], pair[1]).at("says"));
    } catch (const Unsupported&) {
      answers.push_back(nullptr);
    }
  }
  return {{"answers", answers}};
}

inline Json reply_to(const Engine& engine, const Json& request, Loaded& loaded) {
  if (request.contains("load")) {
    loaded = load(engine, request["load"]);
    return {{"loaded", true}};
  }
  Question question{request.at("question"), {}, {}};
  if (request.contains("settings"))
    question.clearance = request["settings"].value("clearance", 0.0);
  const bool is_about_bodies = request.contains("bodies");
  if (is_about_bodies ? !loaded.shapes : !loaded.meshes)
    throw std::runtime_error("a question before a load");
  const auto start = std::chrono::steady_clock::now();
  Json reply;
  if (is_about_bodies) {
    reply = answer_about_bodies(loaded.shapes, request, question);
  } else {
    question.pose_a = request.at("pose_a");
    question.pose_b = request.at("pose_b");
    reply["answer"] = loaded.meshes(question);
  }
  const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
  reply["us"] = time.count();
  return reply;
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
  Loaded loaded;
  for (std::string line; std::getline(std::cin, line);) {
    const Json request = Json::parse(line);
    Json reply;
    try {
      reply = reply_to(engine, request, loaded);
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
