#pragma once

// For those who only pass handles around, this declares the classes, settings and results that
// programs pass around. Only ids and pairs are defined, as values; no other header is included.
// <graze/graze.h> has all of it.

#include <graze/engine/world/ids.h>

namespace graze {

class Error;
struct ErrorPlace;
class InputError;
class MeshError;
class PoseError;
class StaleIdError;
class StoppedError;
class UnsupportedPairError;

struct Aabb;
struct Ellipsoid;
struct Obb;
struct Ray;
struct Sphere;
struct Triangle;
struct EdgePath;
struct PointPath;
struct TrianglePath;
template <int K>
struct KDop;

class Compound;
class VoxelMap;
class Mesh;
class MeshPath;
struct MeshInPoses;
struct ShapeInPoses;
struct ShapeInMotions;
struct PlacedMesh;
struct PlacedMeshView;
class PairMemory;
class RigidMotion;
struct RigidPair;
struct RigidCourse;
struct RigidVelocities;
struct Screw;
struct Topology;

struct BatchSettings;
struct CastSettings;
struct CheckSettings;
struct ContactSettings;
struct DistanceSettings;
struct FirstContactSettings;
struct IntersectionSettings;
struct HeightFieldSettings;
struct ManifoldSettings;
struct MemoryPairSettings;
struct MemoryQuerySettings;
struct PairSettings;
struct PartSettings;
struct PrepareSettings;
struct QuerySettings;
struct RigidContactSettings;
struct SelfQuerySettings;
struct SelfSettings;
struct TriangleSettings;
struct VolumeQuerySettings;
struct VoxelSettings;
struct VoxelWriteSettings;

struct MeshCast;
struct MeshContact;
struct MeshContacts;
struct FirstContact;
struct MeshDistance;
struct MeshFirstContact;
struct MeshHealth;
struct MeshIntersection;
struct RayHit;
struct NearestPoint;
struct TriangleIntersection;
struct TriangleRayHit;
struct VolumeFit;
struct MeshFit;
struct FreedomCertificate;
struct RigidContact;
struct Separation;
struct TriangleDistance;
struct TriangleList;
struct TrianglePair;
struct TrianglePairs;
struct VolumeCast;
struct Voxel;
struct VoxelGrid;
struct Voxels;
struct Work;

class ConvexHull;
class HeightField;
class Shape;
struct Box;
struct Capsule;
struct Cone;
struct Cylinder;
struct HalfSpace;
struct Plane;
struct PlacedShape;
struct PlacedShapeView;
struct ContactFeature;
class Manifold;
class MeshSides;
struct ShapeCast;
struct ShapeContact;
struct ShapeDistance;
struct ShapeSeparation;

class BodyShape;
class BroadPhase;
class World;
class WorldSnapshot;
struct BodyCast;
struct BodyContact;
struct BodyDistance;
struct BodyFirstContact;
struct BodyPairDistance;
struct BodyQuerySettings;
struct BodyRayHit;
struct BodySettings;
struct BroadPhaseSettings;
struct Filter;
struct PlacedBodyShape;
struct PlacedWorldView;
struct WorldBodyPair;
class WorldDrawer;
struct WorldDrawingSettings;
struct WorldPairSettings;
struct WorldSettings;
struct WorldUpdate;
struct WorldWork;

}  // namespace graze
