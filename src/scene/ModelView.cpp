#include "scene/ModelView.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "scene/Scene.h"

namespace velum::scene {

namespace {

constexpr std::uint32_t kSureInstances = 100;  ///< fewer lie by chance as they do
constexpr double kRound = 0.1;                 ///< that shares of two directions may differ by in what is round
/// How much the oblique view of round things weighs beside the shape of the whole; of its right, up, depth.
constexpr double kObliqueWeight = 0.1, kObliqueParts[] = {0.45, 0.35, 0.2};
const glm::dvec3 kObliqueEye(-0.55, -1.0, 0.35);

/// How the mass of something is spread: sums over balls, each weighted by its volume.
struct Spread {
  double mass = 0.0;
  glm::dvec3 first{0.0};
  glm::dmat3 second{0.0};
  std::uint32_t count = 0;

  void add(glm::dvec3 at, double radius) {
    double weight = radius * radius * radius;
    mass += weight;
    first += weight * at;
    second += weight * (glm::outerProduct(at, at) + glm::dmat3(radius * radius / 5.0));
    ++count;
  }
  void add(const Spread& other) {
    mass += other.mass;
    first += other.first;
    second += other.second;
    count += other.count;
  }
  /// Covariance of a size of one: how far it reaches along each direction, of all of it.
  glm::dmat3 shape() const {
    glm::dvec3 middle = first / mass;
    glm::dmat3 around = second / mass - glm::outerProduct(middle, middle);
    return around / (around[0][0] + around[1][1] + around[2][2]);
  }
};

/// Of each compartment with all that is in it.
std::vector<Spread> spreadsOf(const Model& model) {
  std::vector<Spread> spreads(model.compartments.size());
  glm::dvec3 middle = 0.5 * (glm::dvec3(model.low) + glm::dvec3(model.high));
  for (const MoleculeType& type : model.types)
    for (std::uint32_t i = type.firstInstance; i < type.firstInstance + type.instanceCount; ++i) {
      const Instance& one = model.instances[i];
      const Molecule& molecule = model.molecules[one.molecule];
      spreads[type.compartment].add(glm::dvec3(one.position + one.rotation * molecule.centre) - middle,
                                    double(molecule.radius));
    }
  for (std::size_t c = spreads.size(); c-- > 1;) spreads[std::size_t(model.compartments[c].parent)].add(spreads[c]);
  return spreads;
}

/// Directions in which a symmetric matrix only stretches, the most stretched first, by turns that clear one number
/// beside the diagonal each.
glm::dmat3 mainAxes(glm::dmat3 m) {
  glm::dmat3 axes(1.0);
  for (int turn = 0; turn < 30; ++turn) {
    int a = turn % 3, b = (turn + 1) % 3;
    double angle = 0.5 * std::atan2(2.0 * m[a][b], m[a][a] - m[b][b]);
    // Of the two angles that clear it the smaller one: with the other the turns would go round and round.
    if (std::abs(angle) > glm::quarter_pi<double>()) angle -= std::copysign(glm::half_pi<double>(), angle);
    glm::dmat3 rotation(1.0);
    rotation[a][a] = rotation[b][b] = std::cos(angle);
    rotation[a][b] = std::sin(angle);
    rotation[b][a] = -std::sin(angle);
    m = glm::transpose(rotation) * m * rotation;
    axes = axes * rotation;
  }
  int order[] = {0, 1, 2};
  std::sort(order, order + 3, [&](int a, int b) { return m[a][a] > m[b][b]; });
  return {axes[order[0]], axes[order[1]], axes[order[2]]};
}

/// Whether something is longer one way than another, and not by chance.
bool hasAxes(const Spread& spread) {
  if (spread.count < kSureInstances || spread.mass <= 0.0) return false;
  glm::dmat3 shape = spread.shape(), axes = mainAxes(shape);
  return glm::dot(axes[0], shape * axes[0]) - glm::dot(axes[2], shape * axes[2]) > kRound;
}

glm::dmat3 obliqueAxes() {
  glm::dvec3 toEye = glm::normalize(kObliqueEye), right = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), toEye));
  return {right, glm::cross(toEye, right), toEye};
}

}  // namespace

bool isModelAlone(const Scene& scene) {
  return scene.model.data && !scene.volume.data && !scene.labels.data && scene.surfaces.empty();
}

Camera frameModel(const Scene& scene, const glm::dmat3& axes, double aspect) {
  const Model& model = *scene.model.data;
  CopyGrid copies = copyGrid(scene.model);
  ModelFrame frame = modelFrame(scene);
  Camera camera = scene.camera;
  double tangent = std::tan(glm::radians(camera.fieldOfViewDeg) * 0.5);
  glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
  double distance = 0.0;
  auto forSpheres = [&](const auto& visit) {
    glm::dvec3 last = copies.step * glm::dvec3(copies.counts - 1);
    for (int corner = 0; corner < (scene.model.copies > 1 ? 8 : 1); ++corner) {
      glm::dvec3 shift = last * glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2);
      for (const Instance& instance : model.instances) {
        const Molecule& molecule = model.molecules[instance.molecule];
        glm::dvec3 at = glm::dvec3(instance.position) + glm::dvec3(instance.rotation * molecule.centre) + shift;
        visit(glm::transpose(axes) * frame.worldOf(at), molecule.radius * frame.length);
      }
    }
  };
  forSpheres([&](glm::dvec3 at, double radius) {
    low = glm::min(low, at - radius);
    high = glm::max(high, at + radius);
  });
  glm::dvec3 middle = 0.5 * (low + high);
  forSpheres([&](glm::dvec3 at, double radius) {
    double across = std::max((std::abs(at.x - middle.x) + radius) / aspect, std::abs(at.y - middle.y) + radius);
    distance = std::max(distance, across / tangent + at.z - middle.z);
  });
  constexpr double kMargin = 1.04;
  camera.up = axes[1];
  camera.target = axes * middle;
  camera.height = kMargin * std::max(high.y - low.y, (high.x - low.x) / aspect);
  camera.eye = camera.target + axes[2] * (distance * kMargin);
  return camera;
}

glm::dmat3 bestSide(const Scene& scene, double aspect) {
  std::vector<Spread> spreads = spreadsOf(*scene.model.data);
  std::vector<glm::dmat3> parts;
  for (const Spread& spread : spreads)
    if (hasAxes(spread)) parts.push_back(spread.shape());
  glm::dmat3 oblique = obliqueAxes(), sum(0.0);
  for (int axis = 0; axis < 3; ++axis)
    sum += kObliqueWeight * kObliqueParts[axis] * glm::outerProduct(oblique[axis], oblique[axis]);
  for (const glm::dmat3& part : parts) sum += part / double(parts.size());
  bool isLong = hasAxes(spreads.front());
  if (isLong) sum += spreads.front().shape();
  glm::dvec3 toEye = mainAxes(sum)[2];
  if (glm::dot(toEye, oblique[2]) < 0.0) toEye = -toEye;
  // In the picture, the whole lies along an edge where it has a longer way.
  glm::dmat3 depth = glm::outerProduct(toEye, toEye), across = glm::dmat3(1.0) - depth;
  glm::dmat3 axes = mainAxes(across * (isLong ? spreads.front().shape() : sum) * across - depth);
  glm::dvec3 up = axes[aspect < 1.0 ? 0 : 1];
  if (glm::dot(up, oblique[1]) < 0.0) up = -up;
  return {glm::cross(up, toEye), up, toEye};
}

}  // namespace velum::scene
