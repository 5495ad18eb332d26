#pragma once

#include <string>
#include <vector>

#include "tests/benchmark/error/elements.h"

namespace graze::benchmark {

/// A library that others made, and its adaptor: a page each in this folder.
struct Peer {
  std::string name;
  void (*add)(Field& field);
};

// One of these for each peer that was found.
void add_bullet(Field& field);
void add_bullet_volumes(Field& field);
void add_ccd(Field& field);
void add_cgal(Field& field);
void add_embree(Field& field);
void add_fcl(Field& field);
void add_fcl_distances(Field& field);
void add_fcl_meshes(MeshContestants& contestants);
void add_fcl_volumes(Field& field);
void add_ode(Field& field);
void add_ode_triangles(Field& field);

/// Those that were found when this was configured.
std::vector<Peer> peers();

/// The names of the others.
std::vector<std::string> absent_peers();

}  // namespace graze::benchmark
