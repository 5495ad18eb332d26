#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/element_error.h>
#include <graze/engine/view/view.h>
#include <graze/engine/view/writing/view_state.h>

#include <algorithm>
#include <cmath>

namespace graze {
namespace {

constexpr std::uint32_t kMostLevel = 99;

void add_segment(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                 std::vector<Eigen::Vector3d>& ends) {
  ends.push_back(from);
  ends.push_back(to);
}

/// Takes what a world draws into a frame.
class FrameDrawer final : public WorldDrawer {
 public:
  explicit FrameDrawer(View& view) : view_(view) {}

  void line(const DrawnLine& line) override { view_.add_line(line.from, line.to); }
  void point(const DrawnPoint& point) override { view_.add_point(point.at); }
  void label(const DrawnLabel& label) override { view_.add_label(label.at, label.text); }

 private:
  View& view_;
};

}  // namespace

void View::mark_triangles(ViewBody body, std::span<const std::uint32_t> triangles) {
  data_->check_body(body);
  const view::ShownBodyData& own = data_->shown.bodies[body.index];
  view::ShownFrame& frame = data_->frame();
  if (!frame.poses.contains(body.index))
    throw InputError(data_->where() + ": '" + own.name + "' is marked, but does not stand there",
                     {.element = "body", .index = body.index});
  const std::size_t count = data_->shown.shapes[own.shape].surface.triangles.size();
  for (const std::uint32_t triangle : triangles)
    if (triangle >= count)
      throw InputError(data_->where() + ": '" + own.name + "' has no triangle " +
                           std::to_string(triangle) + ", but " + std::to_string(count),
                       {.element = "triangle", .index = triangle});
  std::vector<std::uint32_t>& marked = frame.triangles[body.index];
  marked.insert(marked.end(), triangles.begin(), triangles.end());
  std::sort(marked.begin(), marked.end());
  marked.erase(std::unique(marked.begin(), marked.end()), marked.end());
}

void View::add_curve(std::span<const Eigen::Vector3d> points) {
  bvh::in_standard_arithmetic([&] {
    for (std::size_t i = 0; i < points.size(); ++i)
      bvh::at_element("point", i, [&] { data_->check(points[i], "a point of a curve"); });
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      add_segment(points[i], points[i + 1], data_->frame().curves);
  });
}

void View::add_line(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  bvh::in_standard_arithmetic([&] {
    data_->check(from, "an end of a line");
    data_->check(to, "an end of a line");
    add_segment(from, to, data_->frame().lines);
  });
}

void View::add_contact(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double depth) {
  bvh::in_standard_arithmetic([&] {
    data_->check(point, "the point of a contact");
    data_->check(normal, "the normal of a contact");
    data_->check(depth, "the depth of a contact");
    if (normal.isZero(0)) throw InputError(data_->where() + ": the normal of a contact is 0");
    data_->frame().contacts.push_back({point, normal.stableNormalized(), depth});
  });
}

void View::add_gap(const Eigen::Vector3d& point_a, const Eigen::Vector3d& point_b,
                   double distance) {
  bvh::in_standard_arithmetic([&] {
    data_->check(point_a, "a nearest point");
    data_->check(point_b, "a nearest point");
    data_->check(distance, "a distance");
    data_->frame().gaps.push_back({point_a, point_b, distance});
  });
}

void View::add_label(const Eigen::Vector3d& at, const std::string& text) {
  bvh::in_standard_arithmetic([&] {
    data_->check(at, "the place of a label");
    data_->frame().labels.push_back({at, text});
  });
}

void View::add_point(const Eigen::Vector3d& at) {
  bvh::in_standard_arithmetic([&] {
    data_->check(at, "a point");
    data_->frame().points.push_back(at);
  });
}

void View::add_plane(const ViewPlane& plane) {
  bvh::in_standard_arithmetic([&] {
    data_->check(plane.point, "the middle of a plane");
    data_->check(plane.normal, "the normal of a plane");
    data_->check(plane.half_extent, "the extent of a plane");
    if (plane.normal.isZero(0)) throw InputError(data_->where() + ": the normal of a plane is 0");
    if (plane.half_extent == 0) throw InputError(data_->where() + ": the extent of a plane is 0");
    data_->frame().planes.push_back(
        {plane.point, plane.normal.stableNormalized(), plane.half_extent});
  });
}

void View::add_pair(ViewBody a, ViewBody b) {
  for (const ViewBody body : {a, b}) {
    data_->check_body(body);
    if (!data_->frame().poses.contains(body.index))
      throw InputError(data_->where() + ": '" + data_->shown.bodies[body.index].name +
                           "' is of a pair, but does not stand there",
                       {.element = "body", .index = body.index});
  }
  if (a.index == b.index)
    throw InputError(
        data_->where() + ": '" + data_->shown.bodies[a.index].name + "' is no pair with itself",
        {.element = "body", .index = a.index});
  data_->frame().pairs.insert(std::minmax(a.index, b.index));
}

void View::add_boxes(ViewBody body, std::uint32_t level, std::span<const Obb> boxes) {
  bvh::in_standard_arithmetic([&] {
    data_->check_body(body);
    view::ShownBodyData& own = data_->shown.bodies[body.index];
    if (level > kMostLevel)
      throw InputError("boxes of '" + own.name + "': level " + std::to_string(level) +
                           ", not 0 to " + std::to_string(kMostLevel),
                       {.element = "level", .index = level});
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      bvh::at_element("box", i, [&] {
        check_box(boxes[i], ("box " + std::to_string(i) + " of '" + own.name + "'").c_str());
      });
    }
    std::vector<Obb>& kept = own.boxes[level];
    kept.insert(kept.end(), boxes.begin(), boxes.end());
  });
}

void View::draw(const World& world, const WorldDrawingSettings& settings) {
  FrameDrawer drawer(*this);
  graze::draw(world, drawer, settings);
}

}  // namespace graze
