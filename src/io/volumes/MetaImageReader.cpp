#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "core/Text.h"
#include "io/read/DataFiles.h"
#include "io/read/FileBytes.h"
#include "io/read/FileNames.h"
#include "io/read/Payload.h"
#include "io/read/Placement.h"
#include "io/volumes/Readers.h"

namespace velum::io {

namespace {

constexpr std::size_t kLongestHeader = 16 << 20;  // tracked ultrasound writes a pose per frame

struct MetaHeader {
  Path file;
  std::map<std::string, std::string> fields;
  std::string dataFileList;
  std::uint64_t headerBytes = 0;

  std::string field(std::initializer_list<const char*> names) const {
    for (const char* name : names)
      if (auto found = fields.find(name); found != fields.end()) return found->second;
    return {};
  }
  bool isTrue(std::initializer_list<const char*> names) const {
    std::string value = field(names);
    return !value.empty() && (value[0] == 'T' || value[0] == 't' || value[0] == '1' || value[0] == 'Y');
  }
  std::vector<double> numbers(std::initializer_list<const char*> names) const {
    std::vector<double> result;
    for (std::string_view word : wordsOf(field(names)))
      if (result.size() < 100) result.push_back(takeNumber(word).value_or(0.0));
    return result;
  }
};

MetaHeader parseHeader(const Path& file) {
  MetaHeader h;
  h.file = file;
  std::uint64_t size = sizeOfFile(file);
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  while (h.headerBytes < kLongestHeader && h.headerBytes < size) {
    // Bounded by hand: a file without line ends must not be read whole.
    line.clear();
    int c;
    while ((c = stream.get()) != EOF && c != '\n' && line.size() < (1 << 20)) line += char(c);
    h.headerBytes += line.size() + (c == '\n');
    auto equals = line.find('=');
    if (equals == std::string::npos) {
      if (trimmed(line).empty()) continue;
      // Samples where a header line should be: the key that ends the header is missing.
      if (std::any_of(line.begin(), line.end(), [](char byte) { return byte >= 0 && byte < 9; })) break;
      refuse(file, fmt::format("its header has a line {} without '='", inQuotes(line)));
    }
    std::string key(trimmed(std::string_view(line).substr(0, equals)));
    h.fields[key] = trimmed(std::string_view(line).substr(equals + 1));
    if (key == "ElementDataFile") break;
  }
  if (h.field({"ElementDataFile"}).empty()) refuse(file, "its header has no ElementDataFile");
  if (h.field({"ElementDataFile"}).starts_with("LIST")) {
    std::string rest(std::min<std::uint64_t>(size - h.headerBytes, kLongestHeader), '\0');
    stream.read(rest.data(), std::streamsize(rest.size()));
    h.dataFileList = rest;
  }
  return h;
}

struct MetaType {
  const char* name;
  StoredType type;
};
// LONG is 4 bytes in files of MetaIO, whatever the machine.
constexpr MetaType kTypes[] = {
    {"MET_CHAR", StoredType::Int8},         {"MET_UCHAR", StoredType::UInt8},   {"MET_SHORT", StoredType::Int16},
    {"MET_USHORT", StoredType::UInt16},     {"MET_INT", StoredType::Int32},     {"MET_UINT", StoredType::UInt32},
    {"MET_LONG", StoredType::Int32},        {"MET_ULONG", StoredType::UInt32},  {"MET_LONG_LONG", StoredType::Int64},
    {"MET_ULONG_LONG", StoredType::UInt64}, {"MET_FLOAT", StoredType::Float32}, {"MET_DOUBLE", StoredType::Float64},
};

Layout layoutOf(const MetaHeader& h, int dimensions) {
  Layout layout;
  std::string type = h.field({"ElementType"});
  std::string base = type.ends_with("_ARRAY") ? type.substr(0, type.size() - 6) : type;
  const MetaType* found = nullptr;
  for (const MetaType& t : kTypes)
    if (base == t.name) found = &t;
  if (!found) refuse(h.file, fmt::format("elements of type {} are not supported", inQuotes(type)));
  layout.type = found->type;
  layout.bigEndian = h.isTrue({"BinaryDataByteOrderMSB", "ElementByteOrderMSB"});
  std::istringstream sizes(h.field({"DimSize"}));
  for (int i = 0; i < dimensions; ++i) {
    std::int64_t size = 0;
    if (!(sizes >> size) || size < 1)
      refuse(h.file, fmt::format("a DimSize of {} is not possible", inQuotes(h.field({"DimSize"}))));
    (i < 3 ? layout.dims[i] : layout.timeSteps) = size;
  }
  std::string channels = h.field({"ElementNumberOfChannels"});
  if (!channels.empty()) layout.channels = std::strtoll(channels.c_str(), nullptr, 10);
  return layout;
}

std::vector<Payload> payloadsOf(const MetaHeader& h, std::uint64_t bytes) {
  std::string name = h.field({"ElementDataFile"});
  bool isLocal = lowerCase(name) == "local";
  std::vector<Path> files = isLocal ? std::vector{h.file} : namedDataFiles(h.file, name, h.dataFileList);
  bool isText = !h.field({"BinaryData"}).empty() && !h.isTrue({"BinaryData"});
  long long skip = std::strtoll(h.field({"HeaderSize"}).c_str(), nullptr, 10);
  if (skip < -1) refuse(h.file, fmt::format("a HeaderSize of {} is not legal", skip));
  std::vector<Payload> parts;
  for (const Path& file : files) {
    Payload part{file, isLocal ? h.headerBytes : 0, 0, isText ? Packing::Text : Packing::Raw};
    if (h.isTrue({"CompressedData"})) part.packing = Packing::Deflate;
    std::uint64_t each = bytes / files.size(), size = sizeOfFile(file);
    if (skip == -1 && size < each)
      refuse(h.file, fmt::format("the header asks for {} bytes of data, the file has {}", each, size));
    if (!isLocal) part.offset = skip == -1 ? size - each : std::uint64_t(skip);
    parts.push_back(part);
  }
  return parts;
}

double mmPerUnit(const MetaHeader& h) {
  std::string unit = h.field({"DistanceUnits"});
  return unit == "um" ? 1e-3 : unit == "cm" ? 10.0 : 1.0;
}

/// Row i of TransformMatrix is the direction of axis i, in left-posterior-superior, as ITK has it.
void place(Volume& v, const MetaHeader& h, std::size_t dimensions) {
  double mm = mmPerUnit(h);
  auto spacings = h.numbers({"ElementSpacing"});
  if (spacings.empty()) spacings = h.numbers({"ElementSize"});
  auto matrix = h.numbers({"TransformMatrix", "Rotation", "Orientation"});
  auto offset = h.numbers({"Offset", "Position", "Origin"});
  std::size_t spatial = std::min<std::size_t>(3, dimensions);
  glm::dvec3 spacing(1.0), origin(0.0);
  glm::dmat3 columns(1.0);
  for (std::size_t i = 0; i < spatial; ++i) {
    bool usable = i < spacings.size() && std::isfinite(spacings[i]) && spacings[i] != 0.0;
    if (!usable) v.isSpacingKnown = false;
    spacing[int(i)] = usable ? spacings[i] * mm : 1.0;
    if (i < offset.size()) origin[int(i)] = offset[i] * mm;
    if (matrix.size() == dimensions * dimensions)
      for (std::size_t j = 0; j < spatial; ++j) columns[int(i)][int(j)] = matrix[i * dimensions + j];
  }
  // A matrix that turns nothing is written of what was never placed, too; whoever knows of a patient names the axes.
  std::string axes = h.field({"AnatomicalOrientation"});
  bool isNamed = !axes.empty() && axes.find('?') == std::string::npos;
  v.isOrientationKnown = matrix.size() == dimensions * dimensions && (isNamed || columns != glm::dmat3(1.0));
  for (int i = 0; i < 3; ++i) columns[i] *= spacing[i];
  placeInWorld(v, columns, origin, glm::abs(spacing));
}

Modality modalityOf(const MetaHeader& h) {
  std::string name = h.field({"Modality"});
  if (name == "MET_MOD_CT") return Modality::CT;
  if (name == "MET_MOD_MR") return Modality::MR;
  if (name == "MET_MOD_US") return Modality::Ultrasound;
  return Modality::Unknown;
}

}  // namespace

UnreadVolume describeMetaImage(const scene::Source& source) {
  MetaHeader h = parseHeader(source.path);
  int dimensions = std::atoi(h.field({"NDims"}).c_str());
  if (dimensions < 2 || dimensions > 4)
    refuse(h.file, fmt::format("{} dimensions are not supported", inQuotes(h.field({"NDims"}))));
  Layout layout = layoutOf(h, dimensions);
  UnreadVolume unread = promiseSamples(layout, payloadsOf(h, layoutBytes(layout, h.file)), h.file);
  Volume& v = unread.head;
  place(v, h, std::size_t(dimensions));
  auto slope = h.numbers({"ElementToIntensityFunctionSlope"}),
       intercept = h.numbers({"ElementToIntensityFunctionOffset"});
  if (!slope.empty() && std::isfinite(slope[0]) && slope[0] != 0.0) v.scale = slope[0];
  if (!intercept.empty() && std::isfinite(intercept[0])) v.offset = intercept[0];
  v.isColor = v.type == SampleType::UInt8 && (v.channels == 3 || v.channels == 4);
  v.modality = modalityOf(h);
  if (h.fields.contains("Seq_Frame0000_ProbeToTrackerTransform") || h.fields.contains("Seq_Frame0000_Timestamp"))
    v.warnings.push_back("the slices are frames of a tracked sweep, not planes of one volume");
  return unread;
}

Volume readMetaImage(const scene::Source& source, Progress& progress) {
  return readSamples(describeMetaImage(source), progress);
}

}  // namespace velum::io
