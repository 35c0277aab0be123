// The elastic sheet: what a step of position based dynamics does to one particle. C++ and GLSL compile this text.
// Frame: the cut's local one, z along its axis, the rest plane at z = 0.
#ifndef VELUM_SHARED_CLOTH_H
#define VELUM_SHARED_CLOTH_H
#include "shared/types.h"
SHARED_BEGIN

SHARED_CONST uint kClothBinding = 0u;        // uniform block
SHARED_CONST uint kPlaceBinding = 0u;        // vec4: place, w: 1 moves, 0 is held
SHARED_CONST uint kVelocityBinding = 1u;     // vec4, length/s
SHARED_CONST uint kFromBinding = 2u;         // places before an iteration
SHARED_CONST uint kToBinding = 3u;           // and after it
SHARED_CONST uint kKernelBinding = 4u;       // vec2: push, pull
SHARED_CONST uint kUserKernelBinding = 5u;
SHARED_CONST uint kRoomBinding = 6u;         // vec2: lowest, highest z of a particle
SHARED_CONST uint kBendBinding = 7u;         // coefficients, see BendStencil
SHARED_CONST uint kRestBinding = 3u;         // uint: bits of the largest speed, length/s; at the end of a step, which writes no places there
SHARED_CONST int kClothGroup = 8;        // threads along x and y of a group
SHARED_CONST int kBendEvery = 4;         // iterations to one that bends, with the stiffness of as many
SHARED_CONST int kMostStrides = 5;
SHARED_CONST int kStencil = 5;               // a bend stencil is kStencil x kStencil coefficients
SHARED_CONST int kBendClasses = 9;           // by distance from either end of a row, in strides: 0, 1, more

/// What a step needs to know. std140.
struct ClothParams {
  ivec4 grid;            ///< x, y: particles; z: user kernels; w: strides
  vec4 halfSize;         ///< xyz: half the rest plane and the reach; w: longest way in a step
  vec4 step;             ///< x: time, s; y: what is left of a velocity; z: pull back to the rest plane, 1/s^2; w: length/s^2 of strength 1
  mat4 kernelFromLocal;  ///< places of the kernel lattice, kernels at integers
  vec4 spacing;          ///< xyz: between kernels along the volume's axes; w: their geometric mean
  ivec4 lattice;         ///< kernels along x, y, z; w: kernels that reach a place, along one axis
  vec4 axisX;            ///< xyz: the volume's unit axes in the frame; axisX.w: area of effect, kernels
  vec4 axisY;
  vec4 axisZ;
  vec4 stretch[kMostStrides];  ///< x: stiffness of an iteration at stride 2^i, y: the same against bending
};

/// A kernel that the user has put somewhere.
struct ClothKernel {
  vec4 place;     ///< xyz: centre; w: half-width
  vec4 strength;  ///< x: push (> 0: to the sheet's positive side, by the least cut), y: pull or push from the centre; z: how
                  ///< high it lifts the rest plane
};

/// Which side of a kernel's centre: -1 to 1. Differs: the sign of [IMC] eq. 3 would jump at the centre, where a sheet then
/// never comes to rest; here it turns round over a quarter of the half-width.
SHARED_FN float kernelSide(float share) { return clamp(4.0f * share, -1.0f, 1.0f); }

/// [IMC] eq. 3 along one axis: a force that falls from 1 to 0 over the half-width.
SHARED_FN float kernelForce(float delta, float halfWidth) {
  float share = delta / halfWidth;
  return abs(share) < 1.0f ? kernelSide(share) * (1.0f - abs(share)) : 0.0f;
}

/// Weight of a kernel at a place, 1 at its centre, 0 at the faces of its box.
SHARED_FN float kernelTent(vec3 delta, vec3 halfWidth) {
  vec3 w = max(vec3(1.0f) - abs(delta) / halfWidth, vec3(0.0f));
  return w.x * w.y * w.z;
}

/// How much of its lift a kernel has at a distance from its centre, in half-widths: 1 to 0, smooth, and positive definite
/// in the plane ([WENDLAND] phi_3,1), so that a surface can be made to pass through any places.
SHARED_FN float liftAt(float share) {
  float rest = max(1.0f - share, 0.0f);
  return rest * rest * rest * rest * (4.0f * share + 1.0f);
}

/// What a stretch constraint asks of its first particle: half of what is missing to the rest length ([PBD] eq. 10, 11);
/// all of it where the other is held.
SHARED_FN vec3 stretchCorrection(vec4 a, vec4 b, float rest) {
  vec3 d = vec3(b.x - a.x, b.y - a.y, b.z - a.z);
  float len = length(d);
  if (len == 0.0f) return vec3(0.0f);
  return d * ((len - rest) / len * (a.w / max(a.w + b.w, 1e-6f)));
}

/// Class of a place in a row of n particles, for constraints that reach `stride` particles: how many of them fit before
/// and behind it, at most two.
SHARED_FN int bendClass(int i, int n, int stride) {
  return min(i / stride, 2) * 3 + min((n - 1 - i) / stride, 2);
}

SHARED_END
#endif
