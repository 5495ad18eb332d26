#pragma once

#include <graze/engine/work.h>

namespace graze {

/// While it exists, the work of Shapes that are asked as BodyShapes on this thread is added to the
/// Work: the callers know only BodyShapes, which a user may write, and which have no counters.
class ShapeWorkScope {
 public:
  explicit ShapeWorkScope(Work& work);
  ~ShapeWorkScope();
  ShapeWorkScope(const ShapeWorkScope&) = delete;
  ShapeWorkScope& operator=(const ShapeWorkScope&) = delete;

 private:
  Work* outer_;
};

/// Returns the Work of the scope of this thread, or one that nobody reads.
Work& shape_work();

}  // namespace graze
