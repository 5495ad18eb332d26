#pragma once

#include <graze/engine/mesh/mesh.h>

#include <span>

#include "tests/engine/first_touch/digest.h"

namespace graze::tests {

/// Whether an answer is worked out by the thread that asks, or may be handed to oneTBB as well,
/// which ThreadSanitizer cannot follow (tests/README.md).
enum class WorkedOutBy { Asker, OneTbbToo };

/// Something that can be the first that is ever asked of two meshes. The answer in all its bits.
struct FirstQuestion {
  const char* name;
  Digest (*ask)(const Mesh& a, const Mesh& b);
  WorkedOutBy by = WorkedOutBy::Asker;
};

/// Every kind of query, and all that a mesh computes when first asked for it. For closed meshes of
/// about a metre around the origin.
std::span<const FirstQuestion> first_questions();

}  // namespace graze::tests
