#include "session/section/InstanceOutlines.h"

#include <algorithm>
#include <cmath>

#include "core/Parallel.h"
#include "core/Units.h"

namespace velum::session {

namespace {

constexpr double kLeastPixels = 0.35;
constexpr std::uint32_t kPiece = 65536;  // instances that one core takes at a time

/// What is the same for all instances of one copy.
struct Crossing {
  const scene::SectionPlane& plane;
  const Model& model;
  const std::vector<char>& isShown;  ///< by type
  scene::ModelFrame frame;
};

void addPiece(const Crossing& crossing, glm::dvec3 shift, std::uint32_t first, std::uint32_t end,
              std::vector<InstanceOutline>& out) {
  for (std::uint32_t i = first; i < end; ++i) {
    const Instance& one = crossing.model.instances[i];
    const Molecule& molecule = crossing.model.molecules[one.molecule];
    if (!crossing.isShown[molecule.type]) continue;
    glm::dvec3 middle = crossing.frame.worldOf(glm::dvec3(one.rotation * molecule.centre + one.position) + shift);
    double radius = molecule.radius * crossing.frame.length, height = scene::heightOverSection(crossing.plane, middle);
    if (std::abs(height) >= radius) continue;
    double shown = std::sqrt(radius * radius - height * height) / crossing.plane.lengthPerPixel;
    glm::dvec2 at = scene::sectionPixelFromWorld(crossing.plane, middle);
    bool isInView =
        at.x > -shown && at.y > -shown && at.x < crossing.plane.size.x + shown && at.y < crossing.plane.size.y + shown;
    if (shown >= kLeastPixels && isInView) out.push_back({at, shown, molecule.type});
  }
}

/// Whether a copy meets the section where it is seen.
bool isMet(const Crossing& crossing, glm::dvec3 shift) {
  glm::dvec3 low(crossing.model.low), high(crossing.model.high);
  glm::dvec3 middle = crossing.frame.worldOf(0.5 * (low + high) + shift);
  double radius = 0.5 * glm::length(high - low) * crossing.frame.length, reach = radius / crossing.plane.lengthPerPixel;
  glm::dvec2 at = scene::sectionPixelFromWorld(crossing.plane, middle), size(crossing.plane.size);
  return std::abs(scene::heightOverSection(crossing.plane, middle)) < radius && at.x > -reach && at.y > -reach &&
         at.x < size.x + reach && at.y < size.y + reach;
}

/// Whether no instance is so large that it would be seen.
bool areAllSmall(const Crossing& crossing) {
  double largest = 0.0;
  for (const Molecule& molecule : crossing.model.molecules) largest = std::max(largest, double(molecule.radius));
  return largest * crossing.frame.length < kLeastPixels * crossing.plane.lengthPerPixel;
}

}  // namespace

InstanceOutlines outlineInstances(const scene::Scene& scene, const scene::SectionPlane& plane, std::size_t most) {
  InstanceOutlines outlines;
  if (!scene.model.data || !scene.model.visible) return outlines;
  const Model& model = *scene.model.data;
  std::vector<char> isShown;
  for (const MoleculeType& type : model.types)
    isShown.push_back(scene.model.types.empty() || scene::typeLook(scene.model, pathOf(model, type)).visible);
  Crossing crossing{plane, model, isShown, scene::modelFrame(scene)};
  if (areAllSmall(crossing)) return outlines;
  scene::CopyGrid grid = scene::copyGrid(scene.model);
  auto count = std::uint32_t(model.instances.size());
  int pieces = int((count + kPiece - 1) / kPiece), copies = std::clamp(scene.model.copies, 1, scene::kMostCopies);
  for (int copy = 0; copy < copies; ++copy) {
    glm::dvec3 cell(copy % grid.counts.x, copy / grid.counts.x % grid.counts.y, copy / (grid.counts.x * grid.counts.y));
    if (!isMet(crossing, grid.step * cell)) continue;
    std::vector<std::vector<InstanceOutline>> found(std::size_t(std::max(pieces, 0)));
    parallelFor(0, pieces, [&](int piece) {
      std::uint32_t first = std::uint32_t(piece) * kPiece;
      addPiece(crossing, grid.step * cell, first, std::min(first + kPiece, count), found[std::size_t(piece)]);
    });
    for (const auto& part : found) outlines.circles.insert(outlines.circles.end(), part.begin(), part.end());
  }
  std::size_t all = outlines.circles.size();
  if (all <= most) return outlines;
  // Every so manyth: of each type about the same share.
  for (std::size_t i = 0; i < most; ++i) outlines.circles[i] = outlines.circles[i * all / most];
  outlines.circles.resize(most);
  outlines.missing = all - most;
  return outlines;
}

}  // namespace velum::session
