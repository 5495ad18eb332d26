#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/bodies/shared_world.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/answers.h>

#include <graze/engine/world/world_drawing.h>

namespace graze::python {
namespace {

/// Keeps all that is drawn.
class Sketch : public WorldDrawer {
 public:
  void line(const DrawnLine& drawn) override { lines.push_back(drawn); }
  void point(const DrawnPoint& drawn) override { points.push_back(drawn); }
  void label(const DrawnLabel& drawn) override { labels.push_back(drawn); }

  std::vector<DrawnLine> lines;
  std::vector<DrawnPoint> points;
  std::vector<DrawnLabel> labels;
};

py::object drawing_of(const Sketch& sketch) {
  static const ResultType kType("WorldDrawing");
  auto lines = new_array<double>({static_cast<py::ssize_t>(sketch.lines.size()), 2, 3});
  double* at = lines.mutable_data();
  for (const DrawnLine& line : sketch.lines) {
    write(line.from, at);
    write(line.to, at + 3);
    at += 6;
  }
  auto bodies = new_array<std::uint64_t>({static_cast<py::ssize_t>(sketch.points.size()), 2});
  std::uint64_t* body = bodies.mutable_data();
  for (const DrawnPoint& point : sketch.points) {
    *body++ = number_of(point.body_a);
    *body++ = number_of(point.body_b);
  }
  py::list labels;
  for (const DrawnLabel& label : sketch.labels)
    labels.append(py::make_tuple(array_of(label.at), label.text, number_of(label.body)));
  return kType(std::move(lines),
               numbers_of<std::uint8_t>(sketch.lines, [](const auto& line) { return line.what; }),
               numbers_of<std::uint64_t>(sketch.lines,
                                         [](const auto& line) { return number_of(line.body); }),
               points_of(sketch.points, [](const auto& point) { return point.at; }),
               std::move(bodies), std::move(labels));
}

}  // namespace

void add_world_drawing(py::module_& module) {
  py::class_<SharedWorld> type(module.attr("World"));
  type.def(
      "draw",
      [](SharedWorld& shared, bool shapes, bool boxes, bool contacts, bool islands, bool labels,
         py::handle segments, py::handle extent) {
        const WorldDrawingSettings settings{
            .has_shapes = shapes,
            .has_boxes = boxes,
            .has_contacts = contacts,
            .has_islands = islands,
            .has_labels = labels,
            .segments = count_from(segments, "segments"),
            .half_space_extent = number_from(extent, "half_space_extent")};
        return drawing_of(shared.ask([&](World& world) {
          Sketch sketch;
          draw(world, sketch, settings);
          return sketch;
        }));
      },
      "draw(self, *, shapes=True, boxes=False, contacts=True, islands=False, labels=False, "
      "segments=24, half_space_extent=10.0)\n--\n\nThe world for people, as a WorldDrawing of "
      "lines, points and words, bodies in the order of their ids; circles have so many segments. "
      "Raises InputError while changes wait for an update if contacts are asked for.",
      py::kw_only(), py::arg("shapes") = true, py::arg("boxes") = false, py::arg("contacts") = true,
      py::arg("islands") = false, py::arg("labels") = false, py::arg("segments") = 24,
      py::arg("half_space_extent") = 10.0);
}

}  // namespace graze::python
