#pragma once

#include <graze/engine/work.h>

namespace graze {

/// While it lives, what Shapes are asked as BodyShapes on this thread adds to the Work: those who
/// ask know only BodyShapes, which a user may write, and which have no counters.
class ShapeWorkScope {
 public:
  explicit ShapeWorkScope(Work& work);
  ~ShapeWorkScope();
  ShapeWorkScope(const ShapeWorkScope&) = delete;
  ShapeWorkScope& operator=(const ShapeWorkScope&) = delete;

 private:
  Work* outer_;
};

/// That Work, or one that nobody reads.
Work& shape_work();

}  // namespace graze
