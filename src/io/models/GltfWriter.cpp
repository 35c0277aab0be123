// A model as glTF 2.0, binary, with EXT_mesh_gpu_instancing.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "io/models/ModelWriters.h"
#include "io/read/GltfFile.h"

namespace velum::io {

namespace {

using namespace gltf;

constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";
constexpr std::size_t kRoundBalls = 100;  // Of a shape with more of them each is an icosahedron.

/// A ball of triangles with the volume of a ball of radius 1.
struct BallMesh {
  std::vector<glm::vec3> directions;
  std::vector<std::uint16_t> corners;
  float radius = 1.0f;  ///< Of its corners.
};

/// As large as a ball: corners lie outside, middles of triangles inside.
void setRadius(BallMesh& ball) {
  double volume = 0.0;
  for (std::size_t i = 0; i < ball.corners.size(); i += 3) {
    glm::dvec3 a(ball.directions[ball.corners[i]]), b(ball.directions[ball.corners[i + 1]]),
        c(ball.directions[ball.corners[i + 2]]);
    volume += glm::dot(a, glm::cross(b, c)) / 6.0;
  }
  ball.radius = float(std::cbrt(4.0 / 3.0 * std::acos(-1.0) / volume));
}

BallMesh icosahedron() {
  const float a = 1.0f / std::sqrt(1.0f + 1.6180340f * 1.6180340f), b = 1.6180340f * a;
  BallMesh ball;
  ball.directions = {{-a, b, 0},  {a, b, 0},  {-a, -b, 0}, {a, -b, 0}, {0, -a, b},  {0, a, b},
                     {0, -a, -b}, {0, a, -b}, {b, 0, -a},  {b, 0, a},  {-b, 0, -a}, {-b, 0, a}};
  ball.corners = {0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4,  11, 10, 2,  10, 7, 6, 7, 1, 8,
                  3, 9,  4, 3, 4, 2, 3, 2, 6, 3, 6, 8,  3, 8,  9,  4, 9, 5, 2, 4,  11, 6,  2,  10, 8,  6, 7, 9, 8, 1};
  setRadius(ball);
  return ball;
}

/// Each triangle in four.
BallMesh finer(const BallMesh& from) {
  BallMesh ball;
  ball.directions = from.directions;
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::uint16_t> middles;
  auto middle = [&](std::uint16_t a, std::uint16_t b) {
    auto [at, isNew] = middles.try_emplace(std::minmax(a, b), std::uint16_t(ball.directions.size()));
    if (isNew) ball.directions.push_back(glm::normalize(from.directions[a] + from.directions[b]));
    return at->second;
  };
  for (std::size_t i = 0; i < from.corners.size(); i += 3) {
    std::uint16_t a = from.corners[i], b = from.corners[i + 1], c = from.corners[i + 2];
    std::uint16_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (std::uint16_t corner : {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca}) ball.corners.push_back(corner);
  }
  setRadius(ball);
  return ball;
}

/// What the mesh of a molecule is made of.
struct Shape {
  std::vector<Ball> balls;
  const BallMesh* each = nullptr;
  std::size_t pointCount() const { return balls.size() * each->directions.size(); }
  std::size_t cornerCount() const { return balls.size() * each->corners.size(); }
};

class Shapes {
 public:
  Shapes(const Model& model, const ModelWriting& how) : mModel(model), mHow(how) {}

  /// The finest level of not too many balls.
  Shape of(std::size_t molecule) const {
    Shape shape;
    if (mHow.levels)
      for (const Level& level : mHow.levels->of(molecule))
        if (level.count > 0 && level.count <= mHow.mostBalls) {
          auto first = mHow.levels->balls.begin() + level.first;
          shape.balls.assign(first, first + level.count);
          break;
        }
    const Molecule& whole = mModel.molecules[molecule];
    if (shape.balls.empty()) shape.balls.push_back({whole.centre, whole.radius, kResidue, 0});
    shape.each = shape.balls.size() <= kRoundBalls ? &mRound : &mCoarse;
    return shape;
  }

 private:
  const Model& mModel;
  const ModelWriting& mHow;
  BallMesh mCoarse = icosahedron(), mRound = finer(mCoarse);
};

std::vector<glm::vec3> pointsOf(const Shape& shape) {
  std::vector<glm::vec3> points;
  points.reserve(shape.pointCount());
  for (const Ball& ball : shape.balls)
    for (const glm::vec3& direction : shape.each->directions)
      points.push_back(ball.centre + direction * (ball.radius * shape.each->radius));
  return points;
}

std::vector<glm::vec3> normalsOf(const Shape& shape) {
  std::vector<glm::vec3> normals;
  normals.reserve(shape.pointCount());
  for (std::size_t b = 0; b < shape.balls.size(); ++b)
    normals.insert(normals.end(), shape.each->directions.begin(), shape.each->directions.end());
  return normals;
}

std::vector<std::uint16_t> cornersOf(const Shape& shape) {
  std::vector<std::uint16_t> corners;
  corners.reserve(shape.cornerCount());
  for (std::size_t b = 0; b < shape.balls.size(); ++b)
    for (std::uint16_t corner : shape.each->corners)
      corners.push_back(std::uint16_t(b * shape.each->directions.size() + corner));
  return corners;
}

GltfJson headOf(const Model& model) {
  double half = std::sqrt(0.5), nanometres = 0.1;
  return {{"asset",
           {{"version", "2.0"},
            {"generator", "Velum"},
            {"extras", {{"unit", "nanometre"}, {"note", "A unit is a nanometre, not a metre."}}}}},
          {"extensionsUsed", {kInstancing}},
          {"extensionsRequired", {kInstancing}},
          {"scene", 0},
          {"scenes", GltfJson::array({{{"name", model.name}, {"nodes", {0}}}})},
          {"nodes", GltfJson::array({{{"name", "model"},
                                      {"rotation", {-half, 0.0, 0.0, half}},
                                      {"scale", {nanometres, nanometres, nanometres}},
                                      {"children", GltfJson::array()}}})},
          {"meshes", GltfJson::array()},
          {"materials", GltfJson::array()},
          {"accessors", GltfJson::array()},
          {"bufferViews", GltfJson::array()}};
}

/// A node with the mesh of a molecule and the places of its instances; its bytes come in this order.
std::size_t addMolecule(GltfJson& gltf, Buffers& buffers, const Molecule& molecule, const Shape& shape,
                        const std::string& name, std::size_t material) {
  std::vector<glm::vec3> points = pointsOf(shape);
  std::size_t count = points.size(), positions = buffers.addPositions(points);
  std::size_t normals = buffers.add(count * 12, count, "VEC3", kFloat, kVertices);
  std::size_t corners = shape.cornerCount();
  std::size_t indices = buffers.add(corners * 2, corners, "SCALAR", kUInt16, kIndices);
  std::size_t mesh = gltf["meshes"].size();
  GltfJson primitive = {
      {"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}, {"indices", indices}, {"material", material}};
  gltf["meshes"].push_back({{"name", name}, {"primitives", GltfJson::array({primitive})}});
  std::size_t instances = molecule.instanceCount;
  std::size_t places = buffers.add(instances * 12, instances, "VEC3", kFloat, kNoTarget);
  std::size_t rotations = buffers.add(instances * 16, instances, "VEC4", kFloat, kNoTarget);
  GltfJson attributes = {{"TRANSLATION", places}, {"ROTATION", rotations}};
  gltf["nodes"].push_back(
      {{"name", name}, {"mesh", mesh}, {"extensions", {{kInstancing, {{"attributes", attributes}}}}}});
  return gltf["nodes"].size() - 1;
}

/// A node for a type; where it is of several molecules these are below it.
void addType(GltfJson& gltf, Buffers& buffers, const Model& model, const Shapes& shapes, std::size_t number,
             const glm::vec3& color) {
  const MoleculeType& type = model.types[number];
  std::string path = pathOf(model, type);
  gltf["materials"].push_back(materialOf(path, color, 0.8));
  std::vector<std::size_t> nodes;
  for (std::uint32_t m = 0; m < type.moleculeCount; ++m) {
    std::uint32_t molecule = type.firstMolecule + m;
    std::string name = type.moleculeCount == 1 ? path : path + " " + std::to_string(m + 1);
    nodes.push_back(addMolecule(gltf, buffers, model.molecules[molecule], shapes.of(molecule), name, number));
  }
  std::size_t node = nodes.front();
  if (nodes.size() > 1) {
    node = gltf["nodes"].size();
    gltf["nodes"].push_back({{"name", path}, {"children", nodes}});
  }
  gltf["nodes"][node]["extras"] = {{"kind", enumName(type.kind)},
                                   {"function", type.function},
                                   {"instances", type.instanceCount},
                                   {"massDalton", type.mass}};
  gltf["nodes"][0]["children"].push_back(node);
}

void writeInstances(const Model& model, const Molecule& molecule, ReplaceFile& file) {
  std::vector<glm::vec3> places;
  std::vector<glm::vec4> rotations;
  for (std::size_t i = molecule.firstInstance; i < std::size_t(molecule.firstInstance) + molecule.instanceCount; ++i) {
    glm::quat q = glm::normalize(model.instances[i].rotation);
    places.push_back(model.instances[i].position);
    rotations.emplace_back(q.x, q.y, q.z, q.w);
  }
  writeAll(file, places);
  writeAll(file, rotations);
}

}  // namespace

void writeModelGltf(const Model& model, const ModelWriting& how, ReplaceFile& file, Progress& progress) {
  Shapes shapes(model, how);
  GltfJson gltf = headOf(model);
  Buffers buffers(gltf);
  for (std::size_t t = 0; t < model.types.size(); ++t) {
    progress.throwIfCancelled();
    addType(gltf, buffers, model, shapes, t, how.colors[t]);
  }
  writeHead(gltf, buffers, file, "the model does not fit into the 4 GB of a glTF file; hide some of its types");
  for (std::size_t m = 0; m < model.molecules.size(); ++m) {
    progress.report(double(m) / double(model.molecules.size()), "writing model");
    progress.throwIfCancelled();
    Shape shape = shapes.of(m);
    writeAll(file, pointsOf(shape));
    writeAll(file, normalsOf(shape));
    writeAll(file, cornersOf(shape));
    writeInstances(model, model.molecules[m], file);
  }
}

}  // namespace velum::io
