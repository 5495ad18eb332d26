#include <graze/engine/python/binding/module.h>

#include <graze/engine/version.h>

// NOLINTNEXTLINE: a macro makes what Python looks for
PYBIND11_MODULE(_graze, module) {
  pybind11::options options;
  options.disable_function_signatures();  // docstrings begin with their own signatures, which
                                          // inspect reads
  module.doc() = "What the package graze is made of: use that.";
  module.attr("__version__") = graze::library_version();
  graze::python::add_errors(module);
  graze::python::add_work(module);
  graze::python::add_meshes(module);
  graze::python::add_shapes(module);
  graze::python::add_height_fields(module);
  graze::python::add_rigid_motions(module);
  graze::python::add_motion_arrays(module);
  graze::python::add_pair_memories(module);
  graze::python::add_pair_queries(module);
  graze::python::add_distances(module);
  graze::python::add_points(module);
  graze::python::add_rays(module);
  graze::python::add_contacts(module);
  graze::python::add_motions(module);
  graze::python::add_mesh_checks(module);
  graze::python::add_fits(module);
  graze::python::add_mesh_paths(module);
  graze::python::add_certificates(module);
  graze::python::add_voxels(module);
  graze::python::add_cases(module);
  graze::python::add_compounds(module);
  graze::python::add_voxel_maps(module);
  graze::python::add_worlds(module);
  graze::python::add_broad_phases(module);
}
