#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/Text.h"
#include "io/read/ByteSink.h"
#include "io/read/FileNames.h"
#include "io/read/Losses.h"
#include "io/volumes/Writers.h"

namespace velum::io {

namespace {

constexpr std::size_t kPiece = 1 << 20;

std::string_view typeName(SampleType type) {
  constexpr std::string_view kNames[] = {"uint8", "int8", "uint16", "int16", "uint32", "int32", "float", "double"};
  return kNames[static_cast<int>(type)];
}

std::string vectorText(const glm::dvec4& v) { return fmt::format("({},{},{})", v.x, v.y, v.z); }

/// A key value may not break its line.
std::string escaped(const std::string& text) {
  std::string result;
  for (char c : text) {
    if (c == '\n' || c == '\\') result += '\\';
    if (c != '\r') result += c == '\n' ? 'n' : c;
  }
  return result;
}

/// Of a field, which knows no escapes.
std::string oneLine(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return text;
}

std::string axesText(const Volume& v) {
  bool hasChannels = v.channels > 1, hasFrames = v.timeSteps > 1;
  std::string sizes, kinds, directions;
  if (hasChannels) {
    sizes = fmt::format("{} ", v.channels);
    kinds = !v.isColor ? "list " : v.channels == 4 ? "RGBA-color " : "RGB-color ";
    directions = "none ";
  }
  const auto& m = v.worldFromVoxel;
  sizes += fmt::format("{} {} {}", v.dims.x, v.dims.y, v.dims.z);
  kinds += "domain domain domain";
  directions += vectorText(m[0]) + " " + vectorText(m[1]) + " " + vectorText(m[2]);
  if (hasFrames) {
    sizes += fmt::format(" {}", v.timeSteps);
    kinds += " time";
    directions += " none";
  }
  // Without a patient the directions are still kept, in a space of no name.
  const char* space = v.isOrientationKnown ? "space: left-posterior-superior" : "space dimension: 3";
  const char* units =
      v.lengthUnit == LengthUnit::Angstrom ? "space units: \"angstrom\" \"angstrom\" \"angstrom\"\n" : "";
  return fmt::format("type: {}\ndimension: {}\n{}\nsizes: {}\nspace directions: {}\n{}kinds: {}\n", typeName(v.type),
                     3 + hasChannels + hasFrames, space, sizes, directions, units, kinds);
}

std::string keyValuesText(const Volume& v, const LabelExtras& extras) {
  std::string text;
  if (v.scale != 1.0 || v.offset != 0.0) text += fmt::format("velum_scale:={}\nvelum_offset:={}\n", v.scale, v.offset);
  if (!v.unit.empty()) text += fmt::format("velum_unit:={}\n", escaped(v.unit));
  if (v.modality != Modality::Unknown) text += fmt::format("velum_modality:={}\n", enumName(v.modality));
  if (v.timeStepSeconds > 0) text += fmt::format("velum_frame_seconds:={}\n", v.timeStepSeconds);
  if (!v.isSpacingKnown) text += "velum_spacing_known:=0\n";
  for (std::size_t i = 0; i < v.channelNames.size(); ++i)
    text += fmt::format("velum_channel_{}:={}\n", i, escaped(v.channelNames[i]));
  for (const auto& [key, value] : extras.nrrdKeyValues) text += fmt::format("{}:={}\n", key, escaped(value));
  return text;
}

}  // namespace

std::vector<std::string> writeNrrdWith(const Volume& v, ReplaceFile& file, const LabelExtras& extras,
                                       Progress& progress) {
  const Path& path = file.target();
  if (lowerExtension(path) == ".nhdr") refuse(path, "detached NRRD headers are not written; use .nrrd");
  ByteSink sink(file);
  sink.write(
      "NRRD0005\n# Complete NRRD file format specification at:\n# http://teem.sourceforge.net/nrrd/format.html\n");
  if (!v.name.empty()) sink.write(fmt::format("content: {}\n", oneLine(v.name)));
  sink.write(axesText(v));
  if (sampleSize(v.type) > 1)
    sink.write(std::endian::native == std::endian::big ? "endian: big\n" : "endian: little\n");
  sink.write(fmt::format("encoding: gzip\nspace origin: {}\n", vectorText(v.worldFromVoxel[3])));
  sink.write(keyValuesText(v, extras));
  sink.write("\n");
  sink.startGzip();
  auto bytes = std::as_bytes(std::span(v.voxels));
  for (std::size_t at = 0; at < bytes.size(); at += kPiece) {
    sink.write(bytes.subspan(at, std::min(kPiece, bytes.size() - at)));
    progress.report(double(at) / double(bytes.size()), "Writing " + path.filename().string());
  }
  sink.finish();
  Losses losses;
  losses.say(v.scale != 1.0 || v.offset != 0.0,
             "NRRD has no scale: other programs read stored samples, of which a value is {} times one plus {}", v.scale,
             v.offset);
  losses.say(trimmed(oneLine(v.name)) != v.name, "the name is written in one line: NRRD has no other");
  return losses.take();
}

std::vector<std::string> writeNrrd(const Volume& volume, ReplaceFile& file, Progress& progress) {
  return writeNrrdWith(volume, file, {}, progress);
}

}  // namespace velum::io
