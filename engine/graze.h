#pragma once

// Everything that a user of graze meets.

#include <graze/bvh/aabb.h>
#include <graze/bvh/error.h>
#include <graze/bvh/fit/aabb_fit.h>
#include <graze/bvh/fit/kdop_fit.h>
#include <graze/bvh/fit/obb_fit.h>
#include <graze/bvh/fit/sphere_fit.h>
#include <graze/bvh/kdop.h>
#include <graze/bvh/obb.h>
#include <graze/bvh/pose.h>
#include <graze/bvh/sphere.h>
#include <graze/bvh/volume.h>
#include <graze/engine/mesh/box_query.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/mesh/self.h>
#include <graze/engine/pose_text.h>
#include <graze/engine/work.h>
#include <graze/narrowphase/derived/triangle_distance.h>
#include <graze/narrowphase/derived/triangle_intersection.h>
#include <graze/narrowphase/triangle.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <graze/narrowphase/volumes/ellipsoid_box.h>
#include <graze/narrowphase/volumes/hollow_overlap.h>
#include <graze/narrowphase/volumes/sphere_batch.h>
#include <graze/narrowphase/volumes/sphere_box.h>
#include <graze/narrowphase/volumes/sphere_overlap.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>
