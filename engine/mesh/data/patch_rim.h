#pragma once

// Whether contacts of two meshes, of which one is a patch of a larger surface, depend on what lies
// beyond the patch. Private to the library.

namespace graze {

/// Notes of this thread: where a surface is followed (InnerSurface::grow()) to where a patch ends
/// and the whole goes on (MeshPatch::is_rim), the patch was too small.
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
