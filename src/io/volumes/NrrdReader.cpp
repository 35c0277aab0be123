#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <optional>

#include "core/Text.h"
#include "io/read/DataFiles.h"
#include "io/read/FileBytes.h"
#include "io/read/FileNames.h"
#include "io/read/Payload.h"
#include "io/read/Placement.h"
#include "io/volumes/NrrdHeader.h"
#include "io/volumes/Readers.h"

namespace velum::io {

namespace {

struct NrrdType {
  StoredType type;
  const char* names;  ///< Between bars.
};
constexpr NrrdType kTypes[] = {
    {StoredType::Int8, "|signed char|int8|int8_t|"},
    {StoredType::UInt8, "|uchar|unsigned char|uint8|uint8_t|"},
    {StoredType::Int16, "|short|short int|signed short|signed short int|int16|int16_t|"},
    {StoredType::UInt16, "|ushort|unsigned short|unsigned short int|uint16|uint16_t|"},
    {StoredType::Int32, "|int|signed int|int32|int32_t|"},
    {StoredType::UInt32, "|uint|unsigned int|uint32|uint32_t|"},
    {StoredType::Int64, "|longlong|long long|long long int|signed long long|signed long long int|int64|int64_t|"},
    {StoredType::UInt64, "|ulonglong|unsigned long long|unsigned long long int|uint64|uint64_t|"},
    {StoredType::Float32, "|float|"},
    {StoredType::Float64, "|double|"},
};

/// One axis of the array, fastest first.
struct Axis {
  std::int64_t size = 0;
  std::string kind;
  double spacing = std::nan("");
  std::optional<std::vector<double>> direction;  ///< In the file's space; none for an axis that is not spatial.
};

double numberOf(std::string_view word) { return takeNumber(word).value_or(std::nan("")); }

/// "(1,0,0) none (0,1,0)": spaces may stand inside the brackets.
std::vector<std::optional<std::vector<double>>> parseVectors(const std::string& text) {
  std::vector<std::optional<std::vector<double>>> result;
  for (std::size_t at = 0; at < text.size();) {
    if (text.compare(at, 4, "none") == 0) {
      result.push_back(std::nullopt);
      at += 4;
    } else if (text[at] == '(') {
      auto end = text.find(')', at);
      if (end == std::string::npos) break;
      std::string inside = text.substr(at + 1, end - at - 1);
      std::replace(inside.begin(), inside.end(), ',', ' ');
      std::vector<double> numbers;
      for (const auto& word : wordsOf(inside)) numbers.push_back(numberOf(word));
      result.push_back(numbers);
      at = end + 1;
    } else {
      ++at;
    }
  }
  return result;
}

std::vector<Axis> parseAxes(const NrrdHeader& h) {
  std::string dimension = h.field("dimension");
  int count = std::atoi(dimension.c_str());
  if (count < 1 || count > 16) refuse(h.file, fmt::format("a dimension of {} is not possible", inQuotes(dimension)));
  std::vector<Axis> axes{std::size_t(count)};
  auto sizes = wordsOf(h.field("sizes"));
  if (sizes.size() != axes.size()) refuse(h.file, fmt::format("has {} sizes for {} dimensions", sizes.size(), count));
  auto kinds = wordsOf(h.field("kinds"));
  auto spacings = wordsOf(h.field("spacings"));
  auto directions = parseVectors(h.field("space directions"));
  if (!directions.empty() && directions.size() != axes.size()) refuse(h.file, "has a wrong number of space directions");
  for (std::size_t i = 0; i < axes.size(); ++i) {
    axes[i].size = std::strtoll(sizes[i].c_str(), nullptr, 10);
    if (axes[i].size < 1) refuse(h.file, fmt::format("a size of {} is not possible", inQuotes(sizes[i])));
    if (i < kinds.size()) axes[i].kind = lowerCase(kinds[i]);
    if (i < spacings.size()) axes[i].spacing = numberOf(spacings[i]);
    if (!directions.empty()) axes[i].direction = directions[i];
  }
  return axes;
}

/// True when the axis lies in space, as far as the file tells.
bool isSpatial(const Axis& axis, bool haveDirections) {
  if (haveDirections) {
    if (!axis.direction) return false;
    // A fourth component is time; an axis along it alone is no axis of space.
    const auto& d = *axis.direction;
    bool inSpace = false;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, d.size()); ++i) inSpace = inSpace || d[i] != 0.0;
    return inSpace || d.size() <= 3;
  }
  return axis.kind.empty() || axis.kind == "domain" || axis.kind == "space" || axis.kind == "???" ||
         axis.kind == "none";
}

/// Which axes are x, y, z; those before are channels, those behind are frames.
struct AxisRoles {
  std::size_t first = 0, count = 0;
};

AxisRoles rolesOf(const NrrdHeader& h, const std::vector<Axis>& axes) {
  bool haveDirections = !h.field("space directions").empty();
  AxisRoles roles;
  while (roles.first < axes.size() && !isSpatial(axes[roles.first], haveDirections)) ++roles.first;
  while (roles.first + roles.count < axes.size() && isSpatial(axes[roles.first + roles.count], haveDirections))
    ++roles.count;
  for (std::size_t i = roles.first + roles.count; i < axes.size(); ++i)
    if (isSpatial(axes[i], haveDirections))
      refuse(h.file, "has an axis between those of space, which is not supported");
  if (roles.count == 4 && axes.size() == 4 && axes[0].size <= 4 && axes[3].size > 4) roles.first = 1;  // colours first
  roles.count = std::min<std::size_t>(roles.count, 3);
  if (roles.count < 2) refuse(h.file, "has fewer than two dimensions of space");
  return roles;
}

Layout layoutOf(const NrrdHeader& h, const std::vector<Axis>& axes, AxisRoles roles) {
  Layout layout;
  std::string type = lowerCase(h.field("type"));
  const NrrdType* found = nullptr;
  for (const NrrdType& t : kTypes)
    if (!type.empty() && std::string_view(t.names).find("|" + type + "|") != std::string_view::npos) found = &t;
  if (!found) refuse(h.file, fmt::format("samples of type {} are not supported", inQuotes(type)));
  layout.type = found->type;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    bool isSpace = i >= roles.first && i < roles.first + roles.count;
    std::int64_t& slot = isSpace           ? layout.dims[int(i - roles.first)]
                         : i < roles.first ? layout.channels
                                           : layout.timeSteps;
    if (axes[i].size > 0x7fffffff || __builtin_mul_overflow(slot, axes[i].size, &slot))
      refuse(h.file, "the sizes are too large");
  }
  std::string endian = lowerCase(h.field("endian"));
  bool needsOrder =
      storedSize(layout.type) > 1 && !h.field("encoding").starts_with("t") && lowerCase(h.field("encoding")) != "ascii";
  if (needsOrder && endian != "little" && endian != "big")
    refuse(h.file, fmt::format("does not say its byte order: 'endian: little' or 'endian: big' is missing{}",
                               endian.empty() ? "" : fmt::format(", it has {}", inQuotes(endian))));
  layout.bigEndian = endian == "big";
  return layout;
}

Packing packingOf(const NrrdHeader& h) {
  std::string encoding = lowerCase(h.field("encoding"));
  if (encoding == "raw") return Packing::Raw;
  if (encoding == "gzip" || encoding == "gz") return Packing::Deflate;
  if (encoding == "ascii" || encoding == "text" || encoding == "txt") return Packing::Text;
  refuse(h.file, fmt::format("the encoding {} is not supported; raw, gzip and ascii are", inQuotes(encoding)));
}

/// Byte after the next @p lines line ends from @p offset.
std::uint64_t skipLines(const Path& file, std::uint64_t offset, long lines) {
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(std::streamoff(offset));
  for (; lines > 0; --lines) {
    std::uint64_t length = 0;
    for (int c; (c = stream.get()) != '\n'; ++length)
      if (c == EOF || length > (1 << 20)) refuse(file, "has fewer lines than its line skip");
    offset += length + 1;
  }
  return offset;
}

/// Bytes that the deflated file claims to hold: its last four bytes, modulo 2^32.
std::uint64_t inflatedSize(const Path& file) {
  unsigned char raw[4] = {};
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(-4, std::ios::end);
  stream.read(reinterpret_cast<char*>(raw), 4);
  return raw[0] | raw[1] << 8 | raw[2] << 16 | std::uint64_t(raw[3]) << 24;
}

std::vector<Payload> payloadsOf(const NrrdHeader& h, std::uint64_t bytes) {
  std::string name = h.field("data file", "datafile");
  bool isAttached = name.empty();
  std::vector<Path> files = isAttached ? std::vector{h.file} : namedDataFiles(h.file, name, h.dataFileList);
  long lines = std::strtol(h.field("line skip", "lineskip").c_str(), nullptr, 10);
  long long skip = std::strtoll(h.field("byte skip", "byteskip").c_str(), nullptr, 10);
  if (lines < 0) refuse(h.file, fmt::format("a line skip of {} is not legal", lines));
  if (skip < -1) refuse(h.file, fmt::format("a byte skip of {} is not legal", skip));
  std::vector<Payload> parts;
  for (const Path& file : files) {
    Payload part{file, skipLines(file, isAttached ? h.headerBytes : 0, lines), 0, packingOf(h)};
    std::uint64_t each = bytes / files.size();
    bool isPacked = part.packing == Packing::Deflate;
    if (skip == -1) {  // the samples are the last bytes
      std::uint64_t size = isPacked ? inflatedSize(file) : sizeOfFile(file);
      if (size < each) refuse(h.file, fmt::format("the header asks for {} bytes of data, the file has {}", each, size));
      (isPacked ? part.skip : part.offset) = size - each;
    } else {
      (isPacked ? part.skip : part.offset) += std::uint64_t(skip);
    }
    parts.push_back(part);
  }
  return parts;
}

/// Of the first axis of space: all have the same.
std::string spaceUnit(const NrrdHeader& h) {
  std::string units = h.field("space units");
  auto first = units.find('"');
  return first == std::string::npos ? units : units.substr(first + 1, units.find('"', first + 1) - first - 1);
}

/// Millimetres; angstrom stay angstrom.
double mmPerUnit(const NrrdHeader& h) {
  std::string unit = spaceUnit(h);
  constexpr std::pair<const char*, double> kUnits[] = {{"m", 1e3},          {"cm", 10.0},        {"um", 1e-3},
                                                       {"\xc2\xb5m", 1e-3}, {"microns", 1e-3},   {"micron", 1e-3},
                                                       {"nm", 1e-6},        {"nanometer", 1e-6}, {"micrometer", 1e-3}};
  for (auto [known, mm] : kUnits)
    if (unit == known) return mm;
  return 1.0;
}

/// Signs that turn the file's space into left-posterior-superior; nothing for a space that is no patient's.
std::optional<glm::dvec3> lpsSigns(std::string space) {
  space = lowerCase(space);
  if (space.ends_with("-time")) space.resize(space.size() - 5);
  if (space == "left-posterior-superior" || space == "lps" || space == "lpst") return glm::dvec3(1, 1, 1);
  if (space == "right-anterior-superior" || space == "ras" || space == "rast") return glm::dvec3(-1, -1, 1);
  if (space == "left-anterior-superior" || space == "las" || space == "last") return glm::dvec3(1, -1, 1);
  return std::nullopt;
}

void placeByDirections(Volume& v, const NrrdHeader& h, const std::vector<Axis>& axes, AxisRoles roles, double mm) {
  auto signs = lpsSigns(h.field("space"));
  v.isOrientationKnown = signs.has_value();
  glm::dvec3 sign = signs.value_or(glm::dvec3(1.0));
  auto vec = [&](const std::vector<double>& d) {
    glm::dvec3 result(0.0);
    for (std::size_t i = 0; i < std::min<std::size_t>(3, d.size()); ++i) result[int(i)] = d[i];
    return result * sign * mm;
  };
  glm::dmat3 columns(0.0);
  glm::dvec3 spacing(1.0);
  for (std::size_t i = 0; i < roles.count; ++i) {
    columns[int(i)] = vec(*axes[roles.first + i].direction);
    spacing[int(i)] = glm::length(columns[int(i)]);
  }
  if (roles.count == 2) columns[2] = glm::normalize(glm::cross(columns[0], columns[1])) * mm;
  auto origins = parseVectors(h.field("space origin"));
  glm::dvec3 origin = !origins.empty() && origins[0] ? vec(*origins[0]) : glm::dvec3(0.0);
  placeInWorld(v, columns, origin, spacing);
  for (std::size_t i = roles.first + roles.count; i < axes.size(); ++i)
    if (axes[i].direction && axes[i].direction->size() > 3) v.timeStepSeconds = std::abs((*axes[i].direction)[3]);
}

void placeBySpacings(Volume& v, const std::vector<Axis>& axes, AxisRoles roles, double mm) {
  glm::dvec3 spacing(mm);
  v.isOrientationKnown = false;
  for (std::size_t i = 0; i < roles.count; ++i) {
    double s = std::abs(axes[roles.first + i].spacing);
    bool usable = std::isfinite(s) && s > 0;
    if (!usable) v.isSpacingKnown = false;
    spacing[int(i)] = usable ? s * mm : 1.0;
  }
  placeInWorld(v, glm::dmat3(spacing.x, 0, 0, 0, spacing.y, 0, 0, 0, spacing.z), glm::dvec3(0.0), spacing);
}

/// What our own writer adds as key/value pairs, and what others commonly do.
void takeKeyValues(Volume& v, const NrrdHeader& h) {
  auto value = [&](const char* key) {
    auto found = h.keyValues.find(key);
    return found == h.keyValues.end() ? std::string() : found->second;
  };
  double scale = numberOf(value("velum_scale")), offset = numberOf(value("velum_offset"));
  if (std::isfinite(scale) && scale != 0.0 && std::isfinite(offset)) {
    v.scale = scale;
    v.offset = offset;
  }
  v.name = h.field("content");
  v.unit = value("velum_unit");
  bool hasChannelNames = h.keyValues.contains("velum_channel_0");
  for (int i = 0; hasChannelNames && i < v.channels; ++i)
    v.channelNames.push_back(value(fmt::format("velum_channel_{}", i).c_str()));
  double seconds = numberOf(value("velum_frame_seconds"));
  if (std::isfinite(seconds) && seconds > 0) v.timeStepSeconds = seconds;
  if (value("velum_spacing_known") == "0") v.isSpacingKnown = false;
  std::string modality = value("velum_modality").empty() ? value("modality") : value("velum_modality");
  auto isSame = [](std::string_view a, std::string_view b) { return lowerCase(a) == lowerCase(b); };
  v.modality = enumValue<Modality>(modality, isSame).value_or(v.modality);
  if (modality == "DWMRI") v.modality = Modality::MR;
}

}  // namespace

UnreadVolume describeNrrd(const scene::Source& source) {
  NrrdHeader h = readNrrdHeader(source.path);
  auto axes = parseAxes(h);
  AxisRoles roles = rolesOf(h, axes);
  Layout layout = layoutOf(h, axes, roles);
  UnreadVolume unread = promiseSamples(layout, payloadsOf(h, layoutBytes(layout, h.file)), h.file);
  Volume& v = unread.head;
  std::string kind = axes[0].kind;
  v.isColor = roles.first == 1 && (kind.find("color") != std::string::npos) && (v.channels == 3 || v.channels == 4) &&
              kind.find("hsv") == std::string::npos && kind.find("xyz") == std::string::npos;
  bool haveDirections = !h.field("space directions").empty();
  v.lengthUnit = spaceUnit(h) == "angstrom" ? LengthUnit::Angstrom : LengthUnit::Millimetre;
  haveDirections ? placeByDirections(v, h, axes, roles, mmPerUnit(h)) : placeBySpacings(v, axes, roles, mmPerUnit(h));
  takeKeyValues(v, h);
  return unread;
}

Volume readNrrd(const scene::Source& source, Progress& progress) { return readSamples(describeNrrd(source), progress); }

}  // namespace velum::io
