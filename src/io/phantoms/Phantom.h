#pragma once
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "io/phantoms/Sample.h"

/// What the phantoms are made of: repeatable random numbers, signed distances (mm, negative inside), and a painter
/// that turns layers of shapes into voxels with soft edges.
namespace velum::io::phantom {

using Vec = glm::vec3;
using Distance = std::function<float(Vec)>;  ///< Signed distance at a world position, mm; at most twice the true one.

// --- Random numbers -------------------------------------------------------------------------------------------------
// A number is a pure function of (seed, index), so that neither the thread count nor the standard library can change
// it.

/// The finaliser of splitmix64.
inline std::uint64_t hash(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}
inline std::uint64_t hash(std::uint64_t seed, std::uint64_t index) { return hash(hash(seed) ^ index); }
/// 0..1, 24 bits.
inline float unit(std::uint64_t bits) { return float(bits >> 40) * (1.0f / 16777216.0f); }
/// Mean 0, variance 1: the sum of four 16-bit uniforms, which needs neither a logarithm nor a cosine.
inline float gaussian(std::uint64_t bits) {
  float sum = float(bits & 0xffff) + float((bits >> 16) & 0xffff) + float((bits >> 32) & 0xffff) + float(bits >> 48);
  return (sum - 131070.0f) * (1.7320508f / 65535.0f);
}

/// A stream of numbers for building a scene in a fixed order.
class Random {
 public:
  explicit Random(std::uint64_t seed) : mSeed(seed) {}
  float uniform(float low = 0.0f, float high = 1.0f) { return low + (high - low) * unit(hash(mSeed, mCount++)); }
  float normal() { return gaussian(hash(mSeed, mCount++)); }
  Vec direction();

 private:
  std::uint64_t mSeed, mCount = 0;
};

/// Smooth value noise, about -1..1, with one bump per unit of length.
float noise(Vec p, std::uint64_t seed);
/// Two octaves of noise, about -1..1.
inline float roughNoise(Vec p, std::uint64_t seed) {
  return 0.7f * noise(p, seed) + 0.35f * noise(p * 2.03f, seed + 1);
}

// --- Signed distances -----------------------------------------------------------------------------------------------

inline float sphere(Vec p, Vec centre, float radius) { return glm::length(p - centre) - radius; }
/// First-order distance, never deeper than the smallest radius.
float ellipsoid(Vec p, Vec centre, Vec radii);
/// The same for an ellipse in a plane, for columns that change slowly along the third axis.
float ellipse(glm::vec2 p, glm::vec2 centre, glm::vec2 radii);
/// A box with rounded edges.
float roundBox(Vec p, Vec centre, Vec halfSize, float radius);
/// Polynomial smooth union and intersection; k is the width of the fillet in mm.
inline float smoothMin(float a, float b, float k) {
  float h = glm::max(k - std::abs(a - b), 0.0f) / k;
  return glm::min(a, b) - h * h * k * 0.25f;
}
inline float smoothMax(float a, float b, float k) { return -smoothMin(-a, -b, k); }
inline float smoothStep(float low, float high, float x) {
  float t = glm::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}
/// A smooth curve through (x, y) knots with ascending x, constant beyond the ends.
float curve(std::span<const glm::vec2> knots, float x);

/// A piece of a tube: a ball that slides from a to b while its radius changes.
struct Segment {
  Vec a, b;
  float radiusA = 1.0f, radiusB = 1.0f;
};
float distance(const Segment& segment, Vec p);
/// A tube along the Catmull-Rom spline through points with radii (xyz, w), `steps` segments per span.
std::vector<Segment> tube(std::span<const glm::vec4> points, int steps = 8);
void append(std::vector<Segment>& to, std::span<const Segment> from);

// --- Painting -------------------------------------------------------------------------------------------------------

struct Box {
  Vec low, high;
};
inline Box boxAround(Vec centre, Vec halfSize) { return {centre - halfSize, centre + halfSize}; }

/// A shape that is evaluated inside its box only.
struct Solid {
  Box box;
  Distance distance;
};

constexpr std::uint16_t kKeepLabel = 0xffff;  ///< A layer with this label changes values only.

/// The union of shapes of one material. Later layers cover earlier ones; edges are mixed by coverage.
struct Layer {
  std::uint16_t label = 0;  ///< 0 takes the label away.
  float value = 0.0f;
  std::vector<Solid> solids = {};
  std::vector<Segment> tubes = {};
  std::vector<std::uint16_t> onto = {};    ///< Paints on voxels of these labels only; empty: everywhere.
  Vec squash{1.0f};                        ///< Tubes are evaluated at world * squash, which makes their sections oval.
  std::function<float(Vec)> texture = {};  ///< Added to `value`.
  float edge = 1.3f;                       ///< Width of a ramp as steep as the soft edge is in its middle, voxels.
};

/// An axis-aligned grid around the world's origin.
struct Grid {
  glm::ivec3 dims;
  Vec spacing;
  double unitMm = 1.0;  ///< Length of the grid's unit, mm: phantoms far from a hand's size use um or metres.
  Vec at(int x, int y, int z) const { return (Vec(x, y, z) - 0.5f * Vec(dims - 1)) * spacing; }
  std::uint64_t index(int x, int y, int z) const {
    return (std::uint64_t(z) * std::uint64_t(dims.y) + std::uint64_t(y)) * std::uint64_t(dims.x) + std::uint64_t(x);
  }
  glm::dmat4 worldFromVoxel() const;
};

/// One slice in the making, shape [y][x].
struct Slice {
  const Grid& grid;
  int z;
  std::span<float> values;
  std::span<std::uint16_t> labels;
};

/// Paints the layers, in order, onto a slice.
void paint(const Slice& slice, std::span<const Layer> layers);

/// Name, type and labels of a phantom.
struct Description {
  std::string name;
  SampleType type;
  Modality modality;
  std::string unit;
  std::vector<LabelInfo> table;
};

/// Makes volume and labels slice by slice on all cores; values are rounded and clamped to the type.
/// @param body  writes one slice; called from any thread, values and labels come as 0
/// @throw Cancelled
Sample fill(const Description& description, const Grid& grid, Progress& progress,
            const std::function<void(const Slice&)>& body);

}  // namespace velum::io::phantom

namespace velum::io {

Sample makeTwoSpheres(int size, Progress& progress);
Sample makeVessels(int size, Progress& progress);
Sample makeTorso(int size, Progress& progress);
Sample makeSeismic(int size, Progress& progress);
Sample makeSkull(int size, Progress& progress);
Sample makeNeurons(int size, Progress& progress);
Sample makeFibres(int size, double contrast, Progress& progress);
Sample makeUltrasound(int size, Progress& progress);
Sample makeHeart(int size, int frames, Progress& progress);
Sample makeHand(int size, Progress& progress);
Sample makeFoot(int size, Progress& progress);
Sample makeLesion(int size, Progress& progress);

}  // namespace velum::io
