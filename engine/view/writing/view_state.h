#pragma once

#include <string>

#include <graze/bvh/error.h>
#include <graze/engine/view/view.h>
#include <graze/engine/view/writing/view_data.h>

namespace graze {

/// Holds the content of a View, and the checks that its functions share.
struct View::Data {
  view::ShownView shown;

  /// Returns the frame that was begun last; one begins if none was.
  view::ShownFrame& frame() {
    if (shown.frames.empty()) shown.frames.push_back({.said = {}});
    return shown.frames.back();
  }

  /// Returns "frame 3" or "frame 3, pose 3".
  std::string where() const {
    if (shown.frames.empty()) return "frame 0";
    const std::string& label = shown.frames.back().said.label;
    return "frame " + std::to_string(shown.frames.size() - 1) + (label.empty() ? "" : ", ") + label;
  }

  ViewBody add_body(std::size_t shape, const char* kind, const ViewBodySettings& settings) {
    const auto index = static_cast<std::uint32_t>(shown.bodies.size());
    std::string name = settings.name;
    if (name.empty()) name.append(kind).append(" ").append(std::to_string(index));
    shown.bodies.push_back({std::move(name), shape, settings.color});
    return {index};
  }

  void check_body(ViewBody body) const {
    if (body.index >= shown.bodies.size())
      throw InputError("body " + std::to_string(body.index) + ": the view has " +
                           std::to_string(shown.bodies.size()),
                       {.element = "body", .index = body.index});
  }

  void check(const Eigen::Vector3d& point, const char* what) const {
    if (!point.allFinite()) throw InputError(where() + ": " + what + " is not finite");
  }

  void check(double length, const char* what) const {
    if (!std::isfinite(length) || length < 0)
      throw InputError(where() + ": " + what + " is negative or not finite");
  }
};

}  // namespace graze
