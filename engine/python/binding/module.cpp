#include <graze/engine/python/binding/module.h>

#include <graze/engine/version.h>

// NOLINTNEXTLINE: a macro makes what Python looks for
PYBIND11_MODULE(_graze, module) {
  pybind11::options options;
  options.disable_function_signatures();  // docstrings begin with their own, which inspect reads
  module.doc() = "What the package graze is made of: use that.";
  module.attr("__version__") = graze::library_version();
  graze::python::add_errors(module);
  graze::python::add_work(module);
  graze::python::add_meshes(module);
  graze::python::add_pair_memories(module);
  graze::python::add_pair_queries(module);
}
