#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/values/height_fields.h>
#include <graze/engine/python/binding/values/shapes.h>

#include <graze/bvh/error.h>
#include <graze/engine/world/fields/field_data.h>
#include <graze/engine/world/shape.h>

#include <string>

namespace graze::python {
namespace {

py::array array_from(const char* function, py::handle argument, const char* name) {
  return py::module_::import("graze._arrays").attr(function)(argument, name).cast<py::array>();
}

bool are_shorts(const py::array& heights) {
  return heights.dtype().kind() == 'u';
}

template <typename Number>
std::span<const Number> numbers_in(const py::array& array) {
  return {static_cast<const Number*>(array.data()), static_cast<std::size_t>(array.size())};
}

/// Holds one value for each cell, or nothing.
class Cells {
 public:
  Cells(py::handle argument, const char* name, const py::array& heights) {
    if (argument.is_none()) return;
    array_ = array_from("bytes_of_cells", argument, name);
    if (array_.shape(0) + 1 == heights.shape(0) && array_.shape(1) + 1 == heights.shape(1)) return;
    throw InputError(std::string(name) + ": the shape " +
                     py::str(py::tuple(array_.attr("shape"))).cast<std::string>() +
                     " is not one less than that of the heights each way");
  }
  std::span<const std::uint8_t> numbers() const { return numbers_in<std::uint8_t>(array_); }

 private:
  py::array array_{py::dtype::of<std::uint8_t>(), std::vector<py::ssize_t>{0}};
};

std::uint32_t count_of(const py::array& heights, int dimension) {
  const py::ssize_t count = heights.shape(dimension);
  if (count > 0xffffffff) throw InputError("heights: are too many");
  return static_cast<std::uint32_t>(count);
}

const HeightField& field_of(const Shape& shape) {
  const HeightField* field = shape.as<HeightField>();
  if (field == nullptr) throw py::type_error("this is no height field");
  return *field;
}

Shape with_heights(const Shape& shape, py::handle first_column, py::handle first_row,
                   py::handle argument) {
  const HeightField& field = field_of(shape);
  const py::array heights = array_from("heights", argument, "heights");
  const FieldRange part{.first_column = static_cast<std::uint32_t>(std::min(
                            count_from(first_column, "first_column"), std::size_t{0xffffffff})),
                        .first_row = static_cast<std::uint32_t>(
                            std::min(count_from(first_row, "first_row"), std::size_t{0xffffffff})),
                        .columns = count_of(heights, 1),
                        .rows = count_of(heights, 0)};
  const bool shorts = are_shorts(heights);
  const py::gil_scoped_release released;
  return shorts ? field.with_heights(part, numbers_in<std::uint16_t>(heights))
                : field.with_heights(part, numbers_in<float>(heights));
}

template <typename Number, typename Get>
py::array_t<Number> cells_of(const HeightFieldData& data, const Get& get) {
  auto array = new_array<Number>(
      {static_cast<py::ssize_t>(data.cell_rows()), static_cast<py::ssize_t>(data.cell_columns())});
  Number* at = array.mutable_data();
  for (std::uint32_t row = 0; row < data.cell_rows(); ++row) {
    for (std::uint32_t column = 0; column < data.cell_columns(); ++column)
      *at++ = get(column, row);
  }
  return array;
}

template <typename Number>
py::array_t<Number> heights_of(const HeightFieldData& data) {
  auto array = new_array<Number>(
      {static_cast<py::ssize_t>(data.rows), static_cast<py::ssize_t>(data.columns)});
  Number* at = array.mutable_data();
  for (std::uint32_t row = 0; row < data.rows; ++row) {
    for (std::uint32_t column = 0; column < data.columns; ++column)
      *at++ = static_cast<Number>(data.stored(column, row));
  }
  return array;
}

}  // namespace

HeightField field_from(const py::args& arguments) {
  const py::array heights = array_from("heights", arguments[0], "heights");
  if (!PySequence_Check(arguments[1].ptr()) || py::len(arguments[1]) != 2)
    throw InputError("spacing: is no pair (between columns, between rows)");
  const auto spacing = py::reinterpret_borrow<py::sequence>(arguments[1]);
  const Cells holes(arguments[4], "holes", heights);
  const Cells materials(arguments[5], "materials", heights);
  const HeightFieldSettings settings{.spacing_x = number_from(spacing[0], "spacing"),
                                     .spacing_y = number_from(spacing[1], "spacing"),
                                     .height_scale = number_from(arguments[2], "height_scale"),
                                     .height_offset = number_from(arguments[3], "height_offset"),
                                     .holes = holes.numbers(),
                                     .materials = materials.numbers()};
  const std::uint32_t columns = count_of(heights, 1);
  const std::uint32_t rows = count_of(heights, 0);
  const bool shorts = are_shorts(heights);
  const py::gil_scoped_release released;
  return shorts ? HeightField(columns, rows, numbers_in<std::uint16_t>(heights), settings)
                : HeightField(columns, rows, numbers_in<float>(heights), settings);
}

py::tuple arguments_of(const HeightField& field) {
  const HeightFieldData& data = HeightFieldAccess::data(field);
  bool has_holes = false;
  for (const auto& tile : data.tiles)
    has_holes = has_holes || !tile->holes.empty();
  const auto is_hole = [&](std::uint32_t column, std::uint32_t row) {
    return field.is_hole(column, row);
  };
  const auto material = [&](std::uint32_t column, std::uint32_t row) {
    return field.material(column, row);
  };
  return py::make_tuple(
      data.has_floats ? py::object(heights_of<float>(data))
                      : py::object(heights_of<std::uint16_t>(data)),
      py::make_tuple(data.spacing_x, data.spacing_y), data.height_scale, data.height_offset,
      has_holes ? py::object(cells_of<bool>(data, is_hole)) : py::none(),
      data.has_materials ? py::object(cells_of<std::uint8_t>(data, material)) : py::none());
}

void add_height_fields(py::module_& module) {
  module.def(
      "_field_with_heights",
      [](const Shape& shape, py::handle column, py::handle row, py::handle heights) {
        return object_of(with_heights(shape, column, row, heights));
      },
      "_field_with_heights(field, first_column, first_row, heights)\n--\n\nSee HeightField.",
      py::arg("field"), py::arg("first_column"), py::arg("first_row"), py::arg("heights"));
  module.def(
      "_mesh_of_field",
      [](const Shape& shape) {
        const HeightField& field = field_of(shape);
        const py::gil_scoped_release released;
        return field.mesh();
      },
      "_mesh_of_field(field)\n--\n\nSee HeightField.", py::arg("field"));
  module.def(
      "_bytes_of_field", [](const Shape& shape) { return field_of(shape).bytes(); },
      "_bytes_of_field(field)\n--\n\nSee HeightField.", py::arg("field"));
}

}  // namespace graze::python
