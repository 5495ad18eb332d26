#pragma once

#include <graze/bvh/build/build.h>
#include <graze/bvh/build/reference.h>

namespace graze::bvh {

/// Builds a tree as build() does, from references to boxes that are known to be valid, in a frame
/// around them. The references are given up as soon as they have served.
Tree build(References references, const LocalFrame& frame, const BuildSettings& settings = {});

}  // namespace graze::bvh
