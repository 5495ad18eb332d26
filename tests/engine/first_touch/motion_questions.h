#pragma once

// Questions of first_questions() about meshes that move.

#include "tests/engine/first_touch/digest.h"

namespace graze {
class Mesh;
}

namespace graze::tests {

Digest on_the_way(const Mesh& a, const Mesh& b);
Digest in_motion(const Mesh& a, const Mesh& b);
Digest certified(const Mesh& a, const Mesh& b);
Digest many_motions(const Mesh& a, const Mesh& b);
Digest straight(const Mesh& a, const Mesh& b);

}  // namespace graze::tests
