#pragma once

// For those who only pass handles around: every class and result of graze by name, ids and pairs as
// values, and no other header. <graze/graze.h> has all of it.

#include <graze/engine/world/ids.h>

namespace graze {

class Error;
struct ErrorPlace;

struct Aabb;
struct Ellipsoid;
struct Obb;
struct Ray;
struct Sphere;
struct Triangle;
template <int K>
struct KDop;

class Mesh;
struct MeshInPoses;
struct PlacedMesh;
struct PlacedMeshView;
class PairMemory;

struct MeshContacts;
struct MeshDistance;
struct MeshIntersection;
struct RayHit;
struct Separation;
struct TriangleList;
struct TrianglePair;
struct TrianglePairs;
struct VoxelGrid;
struct Voxels;
struct Work;

class ConvexHull;
class Shape;
struct PlacedShape;
struct PlacedShapeView;
struct Manifold;
struct ShapeContact;
struct ShapeDistance;

class BodyShape;
class BroadPhase;
class World;
class WorldSnapshot;
struct BodyContact;
struct BodyDistance;
struct BodyRayHit;
struct BodySettings;
struct WorldSettings;
struct WorldUpdate;

}  // namespace graze
