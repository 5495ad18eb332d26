#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/world/shape.h>

#include <functional>
#include <string>
#include <vector>

namespace graze::benchmark {

/// From where to where a body goes, straight and turning the short way.
struct Ends {
  Pose start;
  Pose end;
};

/// The time at which two shapes meet first, infinite for never, as somebody has it.
using AskMotions = std::function<double(const Ends& a, const Ends& b)>;

/// Somebody who can be asked about shapes in motion.
struct ShapePeer {
  std::string name;
  std::function<AskMotions(const Shape& a, const Shape& b)> load;  ///< what is built once
};

/// A library that was looked for when this was configured.
struct Peer {
  const char* name;
  void (*add)(std::vector<ShapePeer>&);
};

std::vector<Peer> peers();
std::vector<std::string> absent_peers();

/// In peers/fcl.cpp.
void add_fcl(std::vector<ShapePeer>& to);

}  // namespace graze::benchmark
