// Models as lists of places.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "core/Text.h"
#include "io/models/ModelWriters.h"
#include "io/read/LineSink.h"

namespace velum::io {

namespace {

std::string oneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 32; }, ' ');
  return text;
}

std::array<std::uint8_t, 3> bytesOf(const glm::vec3& color) {
  glm::vec3 c = glm::clamp(color, 0.0f, 1.0f) * 255.0f + 0.5f;
  return {std::uint8_t(c.r), std::uint8_t(c.g), std::uint8_t(c.b)};
}

std::uint32_t numberOf(const ModelWriting& how, std::size_t instance) {
  return how.numbers.empty() ? std::uint32_t(instance) : how.numbers[instance];
}

void tellProgress(const Model& model, std::size_t instance, Progress& progress) {
  if (instance % 16384 != 0) return;
  progress.throwIfCancelled();
  progress.report(double(instance) / double(model.instances.size()), "writing model");
}

template <class T>
std::byte* put(std::byte* to, const T& value) {
  std::memcpy(to, &value, sizeof value);
  return to + sizeof value;
}

}  // namespace

void writeModelCsv(const Model& model, const ModelWriting& how, ReplaceFile& file, Progress& progress) {
  LineSink lines(file);
  lines.add(
      "type,compartment,instance,x_angstrom,y_angstrom,z_angstrom,qw,qx,qy,qz,middle_x_angstrom,middle_y_angstrom,"
      "middle_z_angstrom,radius_angstrom,color\n");
  for (std::size_t t = 0; t < model.types.size(); ++t) {
    const MoleculeType& type = model.types[t];
    std::string path = pathOf(model, type), compartment = path.substr(0, path.size() - type.name.size());
    if (!compartment.empty()) compartment.pop_back();
    auto color = bytesOf(how.colors[t]);
    std::string head = csvQuoted(oneLine(type.name)) + "," + csvQuoted(oneLine(compartment));
    for (std::size_t i = type.firstInstance; i < std::size_t(type.firstInstance) + type.instanceCount; ++i) {
      tellProgress(model, i, progress);
      const Instance& instance = model.instances[i];
      const glm::vec3 p = instance.position, m = middleOf(model, instance);
      const glm::quat q = instance.rotation;
      lines.add("{},{},{},{},{},{},{},{},{},{},{},{},{},#{:02x}{:02x}{:02x}\n", head, numberOf(how, i), p.x, p.y, p.z,
                q.w, q.x, q.y, q.z, m.x, m.y, m.z, model.molecules[instance.molecule].radius, color[0], color[1],
                color[2]);
    }
  }
  lines.finish();
}

void writeModelPly(const Model& model, const ModelWriting& how, ReplaceFile& file, Progress& progress) {
  static_assert(std::endian::native == std::endian::little, "as the head says");
  LineSink head(file);
  head.add("ply\nformat binary_little_endian 1.0\ncomment Velum: {}\ncomment angstrom\n", oneLine(model.name));
  for (std::size_t t = 0; t < model.types.size(); ++t)
    head.add("comment type {} {}\n", t, oneLine(pathOf(model, model.types[t])));
  head.add("element vertex {}\n", model.instances.size());
  for (const char* name : {"x", "y", "z", "radius", "qw", "qx", "qy", "qz"}) head.add("property float {}\n", name);
  for (const char* name : {"red", "green", "blue"}) head.add("property uchar {}\n", name);
  for (const char* name : {"type", "instance"}) head.add("property uint {}\n", name);
  head.add("end_header\n");
  head.finish();
  constexpr std::size_t kPoint = 8 * 4 + 3 + 2 * 4, kPiece = 16384;
  std::vector<std::byte> bytes;
  for (std::size_t i = 0; i < model.instances.size();) {
    tellProgress(model, i, progress);
    std::size_t end = std::min(i + kPiece, model.instances.size());
    bytes.resize(kPoint * (end - i));
    for (std::byte* to = bytes.data(); i < end; ++i) {
      const Instance& instance = model.instances[i];
      const Molecule& molecule = model.molecules[instance.molecule];
      const glm::quat q = instance.rotation;
      to = put(put(to, middleOf(model, instance)), molecule.radius);
      to = put(put(to, std::array{q.w, q.x, q.y, q.z}), bytesOf(how.colors[molecule.type]));
      to = put(put(to, molecule.type), numberOf(how, i));
    }
    file.write(bytes);
  }
}

}  // namespace velum::io
