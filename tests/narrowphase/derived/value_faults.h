#pragma once

#include <string>

#include <tests/oracle/shapes.h>

namespace graze::oracle {

/// What is wrong with distance() of two triangles, by laws 4 and 7 and rational arithmetic, and the
/// case as a text; empty if nothing is. Its exact stage is judged, too.
std::string distance_fault(const TrianglePair& pair);

/// Likewise with intersection().
std::string intersection_fault(const TrianglePair& pair);

}  // namespace graze::oracle
