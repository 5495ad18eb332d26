#include <graze/engine/world/shapes/shape_work.h>

#include <utility>

namespace graze {
namespace {

thread_local Work* asked_for = nullptr;

}  // namespace

ShapeWorkScope::ShapeWorkScope(Work& work) : outer_(std::exchange(asked_for, &work)) {}

ShapeWorkScope::~ShapeWorkScope() {
  asked_for = outer_;
}

Work& shape_work() {
  static thread_local Work unread;
  return asked_for != nullptr ? *asked_for : unread;
}

}  // namespace graze
