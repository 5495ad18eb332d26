#pragma once

#include <iosfwd>

#include <graze/engine/compare/peers/engine.h>

namespace graze::compare {

/// Serves the other side of the protocol: says who the engine is, and answers each line of
/// `requests` by a line on the descriptor `replies`, until there are no more. What the engine
/// throws is told as an error, and so is a line that is no request. Questions with "alone" are
/// answered by a copy of the process.
void serve_engine(const Engine& engine, std::istream& requests, int replies);

}  // namespace graze::compare
