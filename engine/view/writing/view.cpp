#include <graze/engine/view/view.h>

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/files/output_file.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/view/packing/packed_text.h>
#include <graze/engine/view/shapes/triangulate.h>
#include <graze/engine/view/writing/packed_view.h>
#include <graze/engine/view/writing/page_text.h>
#include <graze/engine/view/writing/view_state.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace graze {

namespace {

void check_settings(const ViewSettings& settings) {
  if (settings.segments < 8 || settings.segments > 1024)
    throw InputError("ViewSettings::segments is " + std::to_string(settings.segments) +
                     ", not 8 to 1024");
}

Aabb bounds_of(const std::vector<Eigen::Vector3d>& vertices) {
  Aabb box{vertices.front(), vertices.front()};
  for (const Eigen::Vector3d& vertex : vertices)
    box = {box.min.cwiseMin(vertex), box.max.cwiseMax(vertex)};
  return box;
}

/// Returns the index of the first shape that is as `is_it` says, or how many shapes there are if
/// none is.
template <typename IsIt>
std::size_t place_of(const std::vector<view::ShownShape>& shapes, const IsIt& is_it) {
  return static_cast<std::size_t>(std::find_if(shapes.begin(), shapes.end(), is_it) -
                                  shapes.begin());
}

std::size_t add_surface(view::Triangulation surface, std::optional<Mesh> mesh,
                        std::vector<view::ShownShape>& shapes) {
  const Aabb bounds = bounds_of(surface.vertices);
  shapes.push_back({std::move(surface), bounds, std::move(mesh)});
  return shapes.size() - 1;
}

/// Returns the index of the mesh, which is added unless it is there.
std::size_t index_of(const Mesh& mesh, std::vector<view::ShownShape>& shapes) {
  const std::size_t at =
      place_of(shapes, [&](const view::ShownShape& known) { return known.mesh == mesh; });
  return at < shapes.size() ? at : add_surface(view::triangulate(mesh), mesh, shapes);
}

/// Returns the index of any shape in the same way.
std::size_t index_of(const Shape& shape, const view::TriangulationSettings& settings,
                     std::vector<view::ShownShape>& shapes) {
  if (const auto* mesh = shape.as<Mesh>()) return index_of(*mesh, shapes);
  view::Triangulation surface = view::triangulate(shape, settings);
  const std::size_t at = place_of(shapes, [&](const view::ShownShape& known) {
    return !known.mesh && known.surface == surface;
  });
  return at < shapes.size() ? at : add_surface(std::move(surface), std::nullopt, shapes);
}

/// Puts a text in a place of the page.
void fill(std::string_view place, const std::string& text, std::string& page) {
  page.replace(page.find(place), place.size(), text);
}

}  // namespace

View::View(ViewSettings settings) : data_(std::make_unique<Data>()) {
  check_settings(settings);
  data_->shown.settings = std::move(settings);
}
View::~View() = default;
View::View(View&& other) noexcept = default;
View& View::operator=(View&& other) noexcept = default;

ViewBody View::add(const Shape& shape, const ViewBodySettings& settings) {
  return bvh::in_standard_arithmetic([&] {
    if (!std::isfinite(settings.half_space_extent) || settings.half_space_extent <= 0)
      throw InputError("ViewBodySettings::half_space_extent is not positive or not finite");
    const std::size_t at = index_of(shape,
                                    {.segments = data_->shown.settings.segments,
                                     .half_space_extent = settings.half_space_extent},
                                    data_->shown.shapes);
    return data_->add_body(at, name_of(shape.kind()), settings);
  });
}

ViewBody View::add(const Mesh& mesh, const ViewBodySettings& settings) {
  return bvh::in_standard_arithmetic([&] {
    return data_->add_body(index_of(mesh, data_->shown.shapes), name_of(ShapeKind::Mesh), settings);
  });
}

void View::add_note(const std::string& note) {
  data_->shown.settings.notes.push_back(note);
}

void View::begin_frame(const ViewFrame& frame) {
  for (const ViewFact& fact : frame.facts)
    if (!std::isfinite(fact.value))
      throw InputError("frame " + std::to_string(data_->shown.frames.size()) + ": '" + fact.name +
                           "' is not finite",
                       {.element = "frame", .index = data_->shown.frames.size()});
  data_->shown.frames.push_back({.said = frame});
}

void View::place(ViewBody body, const Pose& pose) {
  bvh::in_standard_arithmetic([&] {
    data_->check_body(body);
    const view::ShownBodyData& own = data_->shown.bodies[body.index];
    check_placement(pose, data_->shown.shapes[own.shape].bounds,
                    (data_->where() + ": the pose of '" + own.name + "'").c_str());
    data_->frame().poses.insert_or_assign(body.index, pose);
  });
}

std::string View::page() const {
  return bvh::in_standard_arithmetic([&] {
    if (data_->shown.frames.empty()) throw InputError("a view without a frame shows nothing");
    std::string page = view::page_text();
    // The title is filled in last, though it stands first in the page: its text is not taken for a
    // place.
    fill("{{data}}", view::base64(view::gzipped(view::packed_view(data_->shown))), page);
    fill("{{title}}", view::html_text(data_->shown.settings.title), page);
    return page;
  });
}

void View::write(const std::filesystem::path& file) const {
  files::write_file(file, page());
}

}  // namespace graze
