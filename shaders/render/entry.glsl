// The face that a stretch of a ray begins on, and what of the stretch is seen on it.
#include "common/volume.glsl"
#include "render/hit.glsl"
#include "render/walk.glsl"

struct Entry {
  int cut;
  float t;           // where the ray has come through the face; < 0: through none
  vec3 normal;
  float extinction;  // of the data's material there, by the transfer function
  bool isSolid;      // a voxel of what begins on it is half opaque, or more
};

/// @param t  where the stretch begins
Entry entryBy(Face face, Ray ray, Walk walk, float t) {
  Entry entry = Entry(face.cut, -1.0, vec3(0.0), 0.0, false);
  if (!isOnFace(face)) return entry;
  entry.t = t;
  entry.normal = faceNormalAt(face, ray.origin + t * ray.direction, ray.direction);
#if LABELS != 2
  entry.extinction = extinctionAt(tableAt(texAt(walk, t)));
#endif
  return entry;
}

const float kHalfOpaque = 0.693147;  // optical depth

/// The cut on whose face something of the stretch shows, or -1: that through which its ray has come into material, less than a
/// voxel before. What begins by itself behind a face, however near, is no face. To be asked of all that shows, in its order.
/// @param from, middle  of what shows
/// @param shown  share of the data's extinction that looks, gradients and inlays leave of it
/// @param isSolid  it begins within what is shown as a surface
int faceSeen(inout Entry entry, Ray ray, float from, float middle, float shown, bool isSolid) {
  if (!hasFlag(kFlagSaysFaces)) return -1;
  if ((from - entry.t) * frame.voxelsPerLength < 0.01)
    entry.isSolid = isSolid || entry.extinction * shown > kHalfOpaque * frame.voxelsPerLength;
  float voxels = (middle - entry.t) * -dot(entry.normal, ray.direction) * frame.voxelsPerLength;
  return entry.t >= 0.0 && entry.isSolid && voxels < 1.0 ? entry.cut : -1;
}
