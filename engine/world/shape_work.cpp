#include <graze/engine/world/shape_work.h>

#include <utility>

namespace graze {
namespace {

thread_local Work* counted = nullptr;

}  // namespace

ShapeWorkScope::ShapeWorkScope(Work& work) : outer_(std::exchange(counted, &work)) {}

ShapeWorkScope::~ShapeWorkScope() {
  counted = outer_;
}

Work& shape_work() {
  static thread_local Work unread;
  return counted != nullptr ? *counted : unread;
}

}  // namespace graze
