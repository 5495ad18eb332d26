#pragma once

#include <pybind11/pybind11.h>

namespace graze::python {

// Each source adds its part to the module, types before those that use them.
void add_errors(pybind11::module_& module);
void add_work(pybind11::module_& module);
void add_meshes(pybind11::module_& module);
void add_shapes(pybind11::module_& module);
void add_height_fields(pybind11::module_& module);
void add_rigid_motions(pybind11::module_& module);
void add_motion_arrays(pybind11::module_& module);
void add_pair_memories(pybind11::module_& module);
void add_pair_queries(pybind11::module_& module);
void add_distances(pybind11::module_& module);
void add_points(pybind11::module_& module);
void add_rays(pybind11::module_& module);
void add_contacts(pybind11::module_& module);
void add_motions(pybind11::module_& module);
void add_mesh_checks(pybind11::module_& module);
void add_fits(pybind11::module_& module);
void add_mesh_paths(pybind11::module_& module);
void add_certificates(pybind11::module_& module);
void add_voxels(pybind11::module_& module);
void add_cases(pybind11::module_& module);
void add_compounds(pybind11::module_& module);
void add_voxel_maps(pybind11::module_& module);
void add_worlds(pybind11::module_& module);
void add_world_settings(pybind11::module_& module);
void add_world_queries(pybind11::module_& module);
void add_world_casts(pybind11::module_& module);
void add_world_states(pybind11::module_& module);
void add_world_pairs(pybind11::module_& module);
void add_world_drawing(pybind11::module_& module);
void add_snapshots(pybind11::module_& module);
void add_broad_phases(pybind11::module_& module);

}  // namespace graze::python
