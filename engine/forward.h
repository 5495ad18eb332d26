#pragma once

// For those who only pass handles around, this declares every class and structure of the public
// headers. Only ids and pairs are defined, as values; no other header is included. <graze/graze.h>
// has all of it.

#include <graze/engine/world/ids.h>

namespace graze {

class CaseError;
class Error;
struct ErrorPlace;
class InputError;
class MeshError;
class PoseError;
class SceneError;
class StaleIdError;
class StoppedError;
class UnsupportedPairError;

class AabbList;
class KDopList;
class ObbList;
struct Aabb;
struct AabbArray;
struct BoxPair;
struct Ellipsoid;
struct HollowAabb;
struct HollowSphere;
struct Obb;
struct Ray;
struct Sphere;
struct SphereArray;
struct Triangle;
struct EdgePath;
struct PointPath;
struct TrianglePath;
template <int K>
struct KDop;
struct PoseEqual;
struct PoseHash;
struct PoseLine;

class Compound;
class VoxelMap;
class Mesh;
class MeshPath;
struct MeshInPoses;
struct MeshInMotion;
struct MeshInMotions;
struct ShapeInPoses;
struct ShapeInMotion;
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
struct SharedPairSettings;
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
struct DuplicateTriangle;
struct FaultyEdge;
struct InsideOutPart;
struct MeshIntersection;
struct IntersectionCurve;
struct IntersectionPatch;
struct IntersectionPoint;
struct IntersectionPolygon;
struct IntersectionSegment;
struct TouchingPoint;
struct RayHit;
struct NearestPoint;
struct TriangleIntersection;
struct TriangleRayHit;
struct VolumeFit;
struct MeshFit;
struct FreedomCertificate;
struct FreedomStep;
struct RigidContact;
struct SeparatingTranslation;
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
struct BoxGap;
struct Capsule;
struct Cone;
struct Cylinder;
struct FieldRange;
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
class ContactTracker;
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
struct BroadPhaseWork;
struct ContactTrackerSettings;
struct DrawnLabel;
struct DrawnLine;
struct DrawnPoint;
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
