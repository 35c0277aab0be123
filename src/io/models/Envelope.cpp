#include "io/models/Envelope.h"

#include <array>
#include <cmath>
#include <glm/gtx/quaternion.hpp>

namespace velum::io {

namespace {

constexpr float kPi = 3.14159265f;
/// angstrom^2 of a leaflet that a lipid takes, measured in a published model of HIV.
constexpr float kLipidArea = 62.0f;
constexpr unsigned kShapes = 12;

/// 0 to 1, a pure function of its index.
float random(std::uint32_t index, std::uint32_t stream) { return randomOf(index, 1000 + stream); }

void addTail(std::vector<Atom>& atoms, glm::vec2 at, unsigned shape, std::uint32_t tail) {
  // 16 carbons, 0.87 angstrom down each, that swing about their axis; from one on the tail leans to a side.
  auto bend = 4u + std::uint32_t(random(shape, tail) * 8.0f);
  float turn = 2.0f * kPi * random(shape, 2 + tail);
  glm::vec2 side(std::cos(turn), std::sin(turn));
  for (std::uint32_t i = 0; i < 16; ++i) {
    float lean = i > bend ? 0.35f * float(i - bend) : 0.0f;
    glm::vec2 p = at + side * ((i % 2 ? 0.45f : -0.45f) + lean);
    atoms.push_back({.position = {p.x, p.y, 14.3f - 0.87f * float(i)}, .element = 6});
  }
}

}  // namespace

std::vector<Atom> lipidAtoms(unsigned shape) {
  std::vector<Atom> atoms;
  auto add = [&](std::uint8_t element, glm::vec3 p) { atoms.push_back({.position = p, .element = element}); };
  // Choline: nitrogen with three methyl groups, on two carbons.
  add(7, {2.6f, 0.6f, 22.6f});
  add(6, {3.9f, 0.2f, 23.3f}), add(6, {2.2f, 2.0f, 22.9f}), add(6, {1.7f, -0.3f, 23.4f});
  add(6, {2.5f, 0.2f, 21.1f}), add(6, {1.2f, 0.4f, 20.4f});
  // Phosphate.
  add(15, {0.0f, 0.0f, 18.2f});
  add(8, {1.2f, -0.1f, 19.1f}), add(8, {-1.2f, 0.7f, 18.6f}), add(8, {-0.1f, -1.4f, 17.9f}),
      add(8, {0.3f, 0.8f, 16.9f});
  // Glycerol, and the esters of both tails.
  add(6, {-0.5f, 0.4f, 15.8f}), add(6, {-1.4f, -0.8f, 15.4f}), add(6, {1.6f, -0.7f, 15.5f});
  add(8, {-2.5f, -0.6f, 14.6f}), add(8, {2.4f, 0.4f, 15.1f}), add(8, {-3.6f, 0.9f, 15.4f}),
      add(8, {3.6f, -1.0f, 15.6f});
  addTail(atoms, {-2.4f, 0.0f}, shape, 0);
  addTail(atoms, {2.4f, 0.0f}, shape, 1);
  return atoms;
}

std::vector<Atom> nucleotideAtoms() {
  std::vector<Atom> atoms;
  auto add = [&](std::uint8_t element, glm::vec3 p) { atoms.push_back({.position = p, .element = element}); };
  add(15, {8.8f, 0.0f, 0.0f});
  add(8, {9.9f, 0.7f, 0.6f}), add(8, {9.1f, -1.2f, -0.8f}), add(8, {7.9f, 1.0f, -0.9f}), add(8, {7.8f, -0.6f, 1.1f});
  // The sugar's ring, and what hangs from it.
  add(6, {6.7f, 1.3f, -0.4f}), add(6, {5.8f, 0.3f, 0.3f}), add(8, {5.2f, -0.8f, -0.5f}), add(6, {4.0f, -0.4f, -1.1f}),
      add(6, {3.9f, 1.0f, -0.6f}), add(6, {4.9f, 1.2f, 0.6f}), add(8, {4.6f, 1.9f, -1.6f});
  // The base, flat across the axis.
  for (int i = 0; i < 6; ++i)
    add(i % 2 ? 7 : 6,
        {1.0f + 1.35f * std::cos(float(i) * kPi / 3.0f), 1.35f * std::sin(float(i) * kPi / 3.0f), -0.3f});
  add(7, {2.9f, -1.1f, -0.8f}), add(8, {-1.5f, 0.3f, -0.3f}), add(7, {0.3f, 2.6f, -0.3f});
  return atoms;
}

glm::vec3 spiralPoint(std::size_t i, std::size_t count) {
  constexpr double kGolden = 2.399963229728653;
  double z = 1.0 - 2.0 * (double(i) + 0.5) / double(count),
         turn = std::fmod(kGolden * double(i), 2.0 * 3.14159265358979);
  double r = std::sqrt(1.0 - z * z);
  return glm::vec3(r * std::cos(turn), r * std::sin(turn), z);
}

std::size_t addEnvelope(ModelBuilder& builder, const EnvelopePlan& plan, const std::function<bool(glm::vec3)>& isFree) {
  std::uint32_t compartment = builder.compartment(plan.path);
  std::size_t all = 0;
  for (float side : {1.0f, -1.0f}) {
    MoleculeType type{.name = side > 0 ? "outer_membrane" : "inner_membrane",
                      .compartment = compartment,
                      .kind = MoleculeKind::Lipid,
                      .function = "membrane",
                      .structure = "made: phospholipid",
                      .origin = plan.origin};
    std::uint32_t index = builder.addType(std::move(type));
    std::array<std::uint32_t, kShapes> molecules{};
    for (unsigned shape = 0; shape < kShapes; ++shape) molecules[shape] = builder.addMolecule(index, lipidAtoms(shape));
    // Where the heads are, 18 angstrom from the middle plane.
    float heads = plan.radius + 18.0f * side;
    auto count = std::size_t(4.0f * kPi * heads * heads / kLipidArea);
    for (std::size_t i = 0; i < count; ++i) {
      glm::vec3 outward = spiralPoint(i, count);
      if (!isFree(plan.middle + outward * (plan.radius + 10.0f * side))) continue;
      auto number = std::uint32_t(i);
      glm::quat up = glm::rotation(glm::vec3(0, 0, 1), outward * side);
      glm::quat spin = glm::angleAxis(2.0f * kPi * random(number, side > 0 ? 10 : 11), glm::vec3(0, 0, 1));
      auto shape = std::size_t(random(number, side > 0 ? 12 : 13) * float(kShapes));
      builder.addInstance(molecules[shape], plan.middle + outward * plan.radius, up * spin);
      ++all;
    }
  }
  return all;
}

}  // namespace velum::io
