#pragma once

// This tells whether contacts of two meshes, of which one is a patch of a larger surface, depend on
// what lies beyond the patch. It is private to the library.

namespace graze {

/// Notes for this thread whether a patch was too small: whether a surface was followed
/// (InnerSurface::grow()) to where the patch ends and the whole goes on (MeshPatch::is_rim).
class PatchRim {
 public:
  static void forget() { is_met() = false; }
  static void meet() { is_met() = true; }
  static bool was_met() { return is_met(); }

 private:
  static bool& is_met() {
    static thread_local bool is_met = false;
    return is_met;
  }
};

}  // namespace graze
