#pragma once

/// For headers that take a scene, or a part of one, by reference: code that uses its members includes Scene.h.
namespace velum::scene {

struct Camera;
struct Cut;
struct LabelLayer;
struct LabelStrength;
struct ModelLayer;
struct Scene;
struct Source;
struct Structure;
struct Surface;
struct Timeline;
struct Track;
struct VolumeLayer;

}  // namespace velum::scene
