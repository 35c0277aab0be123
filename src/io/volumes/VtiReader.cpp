#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <new>
#include <optional>
#include <stdexcept>
#include <vector>

#include "core/Text.h"
#include "io/read/FileBytes.h"
#include "io/read/Placement.h"
#include "io/read/SampleBytes.h"
#include "io/read/VtkXml.h"
#include "io/volumes/Readers.h"
#include "io/volumes/VtiNotes.h"

/// VTK image data in XML. VTK has no patient axes of its own; its world is taken as ours, millimetres in LPS, which is
/// what ITK-based programs write. A file without a Direction matrix says nothing of the patient.
namespace velum::io {

namespace {

template <std::size_t N>
std::optional<std::array<double, N>> numbersIn(std::string_view text) {
  std::array<double, N> out;
  for (double& value : out) {
    auto number = takeNumber(text);
    if (!number) return std::nullopt;
    value = *number;
  }
  return out;
}

/// The numbers of an attribute; @p otherwise where there is none, not-a-numbers where it is damaged.
template <std::size_t N>
std::array<double, N> numbersOr(std::string_view text, const std::array<double, N>& otherwise) {
  if (text.empty()) return otherwise;
  std::array<double, N> damaged;
  damaged.fill(std::nan(""));
  return numbersIn<N>(text).value_or(damaged);
}

constexpr std::array<double, 9> kAlongAxes{1, 0, 0, 0, 1, 0, 0, 0, 1};

/// First and last index along each axis, both of it.
struct Extent {
  glm::i64vec3 first{0}, last{0};

  /// Points, or cells; a flat image has one layer of cells.
  glm::i64vec3 dims(bool ofCells) const {
    return ofCells ? glm::max(last - first, glm::i64vec3(1)) : last - first + std::int64_t(1);
  }
  bool holds(const Extent& e) const {
    return glm::all(glm::lessThanEqual(first, e.first)) && glm::all(glm::lessThanEqual(e.last, last));
  }
};

Extent extentOf(std::string_view text, const Path& path) {
  auto n = numbersIn<6>(text);
  Extent extent;
  bool isSane = n.has_value();
  for (int i = 0; i < 3 && isSane; ++i) {
    double first = (*n)[std::size_t(i) * 2], last = (*n)[std::size_t(i) * 2 + 1];
    isSane = std::abs(first) < 1e9 && last >= first && last - first < 1e6 && first == std::floor(first) &&
             last == std::floor(last);
    extent.first[i] = isSane ? std::int64_t(first) : 0;
    extent.last[i] = isSane ? std::int64_t(last) : 0;
  }
  if (!isSane) refuse(path, fmt::format("an extent of {} makes no sense", inQuotes(text)));
  return extent;
}

/// The image's array: that which is named as scalars, else the first; of the points before the cells.
const XmlElement* arrayIn(const XmlElement& piece, const char* attributes) {
  const XmlElement* all = piece.child(attributes);
  if (!all) return nullptr;
  std::string_view wanted = all->attribute("Scalars");
  const XmlElement* first = nullptr;
  for (const XmlElement& array : all->children) {
    if (array.name != "DataArray") continue;
    if (!wanted.empty() && array.attribute("Name") == wanted) return &array;
    if (!first) first = &array;
  }
  return first;
}

struct Piece {
  Extent extent;
  VtkArray array;
};

/// The pieces with what they say of their values; nothing is read yet.
std::vector<Piece> piecesOf(const VtkXml& xml, bool ofCells) {
  std::vector<Piece> pieces;
  for (const XmlElement& piece : xml.data().children) {
    if (piece.name != "Piece") continue;
    const XmlElement* array = arrayIn(piece, ofCells ? "CellData" : "PointData");
    if (!array) continue;
    std::string_view extent = piece.attribute("Extent");
    if (extent.empty()) extent = xml.data().attribute("WholeExtent");
    pieces.push_back({extentOf(extent, xml.file().path()), VtkArray(xml, *array)});
  }
  return pieces;
}

/// What the pieces hold, compared with what the image needs and the file can justify.
std::size_t checkPieces(std::span<const Piece> pieces, const Extent& whole, bool ofCells, const VtkXml& xml) {
  const Path& path = xml.file().path();
  const VtkArray& first = pieces[0].array;
  auto countOf = [&](const Extent& e) {
    glm::i64vec3 dims = e.dims(ofCells);
    return double(dims.x) * double(dims.y) * double(dims.z);
  };
  double held = 0;
  for (const Piece& piece : pieces) {
    if (!whole.holds(piece.extent)) refuse(path, "is damaged: a piece lies outside the image");
    if (piece.array.type() != first.type() || piece.array.components() != first.components())
      refuse(path, "is damaged: its pieces have values of different types");
    double values = countOf(piece.extent) * first.components();
    if (values > 1e13) refuse(path, fmt::format("{:.0f} values make no sense", values));
    piece.array.check(std::uint64_t(values));
    held += countOf(piece.extent);
  }
  if (held < countOf(whole)) refuse(path, "is damaged: its pieces do not fill the image");
  // Pieces may name the same bytes; the text of a number is shorter than the number.
  double most = double(xml.file().size()) * (xml.packing() == VtkPacking::None ? 8.0 : 20000.0);
  return checkedBytes(path, whole.dims(ofCells), first.components(), 1, sampleSize(first.type()), most);
}

void readPiece(const Piece& piece, const Extent& whole, bool ofCells, Volume& v, Progress& progress) {
  glm::i64vec3 dims = piece.extent.dims(ofCells), at = piece.extent.first - whole.first;
  std::size_t voxel = sampleSize(v.type) * std::size_t(v.channels), row = std::size_t(dims.x) * voxel;
  if (dims == glm::i64vec3(v.dims)) return piece.array.read(v.voxels, progress);
  Bytes values(row * std::size_t(dims.y * dims.z));
  piece.array.read(values, progress);
  at = glm::min(at, glm::i64vec3(v.dims) - dims);  // the one layer of a flat image's cells
  for (std::int64_t z = 0; z < dims.z; ++z)
    for (std::int64_t y = 0; y < dims.y; ++y) {
      std::int64_t to = ((at.z + z) * v.dims.y + at.y + y) * v.dims.x + at.x;
      std::memcpy(v.voxels.data() + std::size_t(to) * voxel, values.data() + std::size_t(z * dims.y + y) * row, row);
    }
}

/// Something of our own in the field data; other field data is none of ours, and is not touched.
const XmlElement* fieldOf(const VtkXml& xml, std::string_view name) {
  const XmlElement* fields = xml.data().child("FieldData");
  if (!fields) return nullptr;
  for (const XmlElement& element : fields->children)
    if (element.name == "DataArray" && element.attribute("Name") == name) return &element;
  return nullptr;
}

double noteOf(const VtkXml& xml, std::string_view name, double otherwise) {
  const XmlElement* element = fieldOf(xml, name);
  if (!element) return otherwise;
  VtkArray array(xml, *element);
  if (array.type() != SampleType::Float64 || array.isWide()) return otherwise;
  double value = 0;
  Progress progress;
  array.check(1);
  array.read(std::as_writable_bytes(std::span(&value, 1)), progress);
  return std::isfinite(value) ? value : otherwise;
}

std::string textOf(const VtkXml& xml, std::string_view name) {
  constexpr double kLongest = 4096;
  const XmlElement* element = fieldOf(xml, name);
  if (!element) return {};
  VtkArray array(xml, *element);
  double length = numbersOr<1>(element->attribute("NumberOfTuples"), {0})[0];
  if (array.type() != SampleType::UInt8 || !(length >= 1 && length <= kLongest)) return {};
  std::string text(std::size_t(length), '\0');
  Progress progress;
  array.check(text.size());
  array.read(std::as_writable_bytes(std::span(text)), progress);
  return text;
}

void takeNotes(Volume& v, const VtkXml& xml) {
  v.scale = noteOf(xml, vti::kScale, 1.0);
  v.offset = noteOf(xml, vti::kOffset, 0.0);
  if (v.scale == 0.0) v.scale = 1.0;
  if (noteOf(xml, vti::kSpacing, 1.0) == 0.0) v.isSpacingKnown = false;
  bool mayBeColor = v.channels == 3 || v.channels == 4;
  v.isColor = mayBeColor && noteOf(xml, vti::kColor, v.type == SampleType::UInt8) != 0.0;
  v.name = textOf(xml, vti::kName);
  v.unit = textOf(xml, vti::kUnit);
  v.modality = enumValue<Modality>(textOf(xml, vti::kModality)).value_or(Modality::Unknown);
  setLengthUnit(v, enumValue<LengthUnit>(textOf(xml, vti::kLengthUnit)).value_or(LengthUnit::Millimetre));
}

/// @param shift  where voxel 0 lies in VTK's index space: the extent's start; plus a half for cells
void place(Volume& v, const XmlElement& image, const glm::dvec3& shift) {
  auto spacing = numbersOr<3>(image.attribute("Spacing"), {1, 1, 1});
  auto origin = numbersOr<3>(image.attribute("Origin"), {0, 0, 0});
  auto turn = numbersOr<9>(image.attribute("Direction"), kAlongAxes);
  glm::dmat3 axes;
  for (std::size_t column = 0; column < 3; ++column)
    for (std::size_t row = 0; row < 3; ++row) axes[int(column)][int(row)] = turn[row * 3 + column] * spacing[column];
  placeInWorld(v, axes, {origin[0], origin[1], origin[2]}, {spacing[0], spacing[1], spacing[2]});
  v.worldFromVoxel[3] = v.worldFromVoxel * glm::dvec4(shift, 1.0);
}

}  // namespace

Volume readVti(const scene::Source& source, Progress& progress) try {
  const Path path = source.path;
  progress.report(0, "reading VTK image");
  FileBytes file(path);
  VtkXml xml(file, "ImageData");
  Extent whole = extentOf(xml.data().attribute("WholeExtent"), path);
  std::vector<Piece> pieces = piecesOf(xml, false);
  bool ofCells = pieces.empty();
  if (ofCells) pieces = piecesOf(xml, true);
  if (pieces.empty()) refuse(path, "has no array of values");
  std::size_t bytes = checkPieces(pieces, whole, ofCells, xml);

  Volume v;
  v.dims = glm::ivec3(whole.dims(ofCells));
  v.channels = pieces[0].array.components();
  v.type = pieces[0].array.type();
  v.voxels.resize(bytes);
  for (const Piece& piece : pieces) readPiece(piece, whole, ofCells, v, progress);
  if (ofCells) v.warnings.push_back("the values stand in cells; each cell is taken as a voxel");
  if (pieces[0].array.isWide()) v.warnings.push_back("64-bit integers are read as doubles");
  bool isNamed = !pieces[0].array.componentName(0).empty();
  for (int i = 0; isNamed && i < v.channels; ++i) v.channelNames.emplace_back(pieces[0].array.componentName(i));
  // VTK writes directions of everything: those along the axes say nothing, if nobody has noted that they do.
  bool isTurned = numbersOr<9>(xml.data().attribute("Direction"), kAlongAxes) != kAlongAxes;
  v.isOrientationKnown = noteOf(xml, vti::kOriented, isTurned ? 1.0 : 0.0) != 0.0;
  place(v, xml.data(), glm::dvec3(whole.first) + (ofCells ? 0.5 : 0.0));
  takeNotes(v, xml);
  return v;
} catch (const std::bad_alloc&) {
  refuse(source.path, "needs more memory than there is");
} catch (const std::length_error&) {
  refuse(source.path, "is damaged (a length in it makes no sense)");
}

}  // namespace velum::io
