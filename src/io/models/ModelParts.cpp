#include "io/models/ModelParts.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "io/read/ByteSource.h"

namespace velum::io {

namespace {

/// Atomic numbers by symbol, of what structures hold.
struct Symbol {
  std::string_view name;
  std::uint8_t number;
};
constexpr Symbol kSymbols[] = {{"H", 1},   {"D", 1},   {"C", 6},   {"N", 7},   {"O", 8},   {"S", 16},  {"P", 15},
                               {"LI", 3},  {"B", 5},   {"F", 9},   {"NA", 11}, {"MG", 12}, {"AL", 13}, {"SI", 14},
                               {"CL", 17}, {"K", 19},  {"CA", 20}, {"CR", 24}, {"MN", 25}, {"FE", 26}, {"CO", 27},
                               {"NI", 28}, {"CU", 29}, {"ZN", 30}, {"AS", 33}, {"SE", 34}, {"BR", 35}, {"MO", 42},
                               {"AG", 47}, {"CD", 48}, {"I", 53},  {"BA", 56}, {"W", 74},  {"PT", 78}, {"AU", 79},
                               {"HG", 80}, {"PB", 82}, {"U", 92}};

}  // namespace

std::string textOf(const Path& path) {
  constexpr std::size_t kPiece = 1 << 20;
  ByteSource source(path);
  std::string text;
  for (std::size_t got = kPiece; got == kPiece;) {
    if (text.size() >= kMostModelBytes)
      refuse(path, fmt::format("holds more than {} MiB, which no model does", kMostModelBytes >> 20));
    std::size_t at = text.size();
    text.resize(at + kPiece);
    got = source.readSome(std::as_writable_bytes(std::span(text)).subspan(at, kPiece));
    text.resize(at + got);
  }
  return text;
}

std::optional<Pose> poseOf(const glm::dmat3& matrix, const glm::dvec3& position) {
  double volume = glm::determinant(matrix);
  bool isPlaced = std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z);
  if (!std::isfinite(volume) || volume < 0.5 || volume > 2.0 || !isPlaced) return std::nullopt;
  glm::dvec3 x = glm::normalize(matrix[0]);
  glm::dvec3 y = glm::normalize(matrix[1] - x * glm::dot(x, matrix[1]));
  return Pose{glm::quat(glm::normalize(glm::quat_cast(glm::dmat3(x, y, glm::cross(x, y))))), glm::vec3(position)};
}

std::uint8_t elementOf(std::string_view symbol) {
  std::string upper;
  for (char c : symbol)
    if (std::isalpha(static_cast<unsigned char>(c))) upper += char(std::toupper(static_cast<unsigned char>(c)));
  for (const Symbol& s : kSymbols)
    if (s.name == upper) return s.number;
  return 6;
}

glm::vec3 meanOf(std::span<const Atom> atoms) {
  glm::dvec3 sum(0.0);
  for (const Atom& atom : atoms) sum += glm::dvec3(atom.position);
  return atoms.empty() ? glm::vec3(0.0f) : glm::vec3(sum / double(atoms.size()));
}

void move(std::vector<Atom>& atoms, glm::vec3 by) {
  for (Atom& atom : atoms) atom.position += by;
}

std::vector<std::string> partsOf(std::string_view dotted) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= dotted.size();) {
    std::size_t dot = std::min(dotted.find('.', at), dotted.size());
    if (dot > at) parts.emplace_back(dotted.substr(at, dot - at));
    at = dot + 1;
  }
  return parts;
}

void place(ModelBuilder& builder, const Path& path, std::uint32_t molecule, const Pose& pose) {
  glm::vec3 p = pose.position;
  if (!(std::abs(p.x) < 1e9f && std::abs(p.y) < 1e9f && std::abs(p.z) < 1e9f))
    refuse(path, "an instance stands nowhere: its place is no number");
  if (builder.instanceCount() >= kMostInstances)
    refuse(path, fmt::format("names more than {} instances", kMostInstances));
  builder.addInstance(molecule, p, pose.rotation);
}

}  // namespace velum::io
