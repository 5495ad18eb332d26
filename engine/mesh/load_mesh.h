#pragma once

#include <filesystem>

#include <graze/engine/mesh/mesh.h>

namespace graze {

/// Reads a triangle mesh from an OBJ, STL (ASCII or binary), PLY (ASCII or binary) or text OFF
/// file, chosen by the file name's ending in upper or lower case. Coordinates are taken as metres.
///
/// Text is rounded once, to double; binary floats are widened exactly. The corners of STL triangles
/// that are bit-equal become one vertex; otherwise vertices and faces keep the order of the file.
/// Polygons become triangles. A convex one becomes a fan from its first corner; a concave one is
/// cut without leaving its outline, decided exactly in the projection onto the coordinate plane
/// where its area is largest; one that crosses itself or has no area is a fan, so that every corner
/// stays covered.
///
/// Normals, colours, texture coordinates, materials, groups, points and lines are skipped. Nothing
/// that has a surface is skipped: free-form geometry, triangle strips, polygons with less than 3
/// corners, bytes behind the last element and numbers that are not finite are errors.
///
/// Throws MeshError with the file and the line or byte for whatever cannot be read. The time is
/// linear in the size of the file, but quadratic in the corners of concave polygons. Memory is
/// proportional to the size of the file, whatever counts it claims.
Mesh load_mesh(const std::filesystem::path& path);

}  // namespace graze
