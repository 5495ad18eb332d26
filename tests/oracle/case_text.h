#pragma once

#include <string>

#include <tests/oracle/shapes.h>

namespace graze::oracle {

/// A pair with its exact answer as the text of a case, the same as in data/regressions: what a
/// failure message shows can be pasted into a file there, and asked again by `graze replay`.
std::string to_text(const TrianglePair& pair, bool intersects);
std::string to_text(const TriangleAndBox& pair, bool intersects);

}  // namespace graze::oracle
