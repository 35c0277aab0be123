#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/Text.h"
#include "io/meshes/MeshParts.h"
#include "io/meshes/MeshReaders.h"
#include "io/read/FileBytes.h"
#include "io/read/VtkXml.h"

/// VTK poly data in XML: points, their normals, polygons and strips of each piece.
namespace velum::io {

namespace {

class VtpReader {
 public:
  VtpReader(const FileBytes& file, Progress& progress)
      : mPath(file.path()), mXml(file, "PolyData"), mProgress(progress) {}

  Mesh read() {
    for (const XmlElement& piece : mXml.data().children)
      if (piece.name == "Piece") readPiece(piece);
    mColors.putInto(mMesh);
    return std::move(mMesh);
  }

 private:
  double countIn(const XmlElement& piece, std::string_view key) const {
    std::string_view text = piece.attribute(key);
    double count = text.empty() ? 0.0 : numberIn(text).value_or(-1.0);
    if (!(count >= 0 && count < 4294967295.0) || count != std::floor(count))
      refuse(mPath, fmt::format("is damaged: {} {} makes no sense", key, inQuotes(text)));
    return count;
  }

  /// The numbers of an array. @param count  of values; what the file cannot hold is refused before it is made
  std::vector<double> numbersOf(const VtkArray& array, std::uint64_t count) {
    array.check(count);
    // Pieces may name the same bytes again and again.
    mTaken += double(count) * double(sampleSize(array.type()));
    if (mTaken > double(mXml.file().size()) * (mXml.packing() == VtkPacking::None ? 8.0 : 20000.0))
      refuse(mPath, "is damaged: its pieces have more values than the file can hold");
    std::vector<std::byte> bytes(std::size_t(count) * sampleSize(array.type()));
    array.read(bytes, mProgress);
    std::vector<double> numbers(static_cast<std::size_t>(count));
    visitType(array.type(), [&](auto sample) {
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        std::memcpy(&sample, bytes.data() + i * sizeof(sample), sizeof(sample));
        numbers[i] = double(sample);
      }
    });
    return numbers;
  }
  template <class Visitor>
  static void visitType(SampleType type, Visitor&& visit) {
    switch (type) {
      case SampleType::UInt8:
        return visit(std::uint8_t());
      case SampleType::Int8:
        return visit(std::int8_t());
      case SampleType::UInt16:
        return visit(std::uint16_t());
      case SampleType::Int16:
        return visit(std::int16_t());
      case SampleType::UInt32:
        return visit(std::uint32_t());
      case SampleType::Int32:
        return visit(std::int32_t());
      case SampleType::Float32:
        return visit(float());
      case SampleType::Float64:
        return visit(double());
    }
  }

  static const XmlElement* arrayNamed(const XmlElement* parent, std::string_view name) {
    if (!parent || name.empty()) return nullptr;
    for (const XmlElement& array : parent->children)
      if (array.name == "DataArray" && array.attribute("Name") == name) return &array;
    return nullptr;
  }

  void readPiece(const XmlElement& piece) {
    auto points = std::uint64_t(countIn(piece, "NumberOfPoints"));
    const XmlElement* place = piece.child("Points");
    const XmlElement* array = place ? place->child("DataArray") : nullptr;
    if (points == 0) return;
    if (!array) refuse(mPath, "is damaged: it has no points");
    VtkArray coordinates(mXml, *array);
    if (coordinates.components() != 3) refuse(mPath, "is damaged: its points have no three coordinates");
    std::size_t first = mMesh.positions.size();
    std::vector<double> p = numbersOf(coordinates, points * 3);
    for (std::size_t i = 0; i < points; ++i)
      mMesh.positions.push_back(pointOf(mPath, {p[i * 3], p[i * 3 + 1], p[i * 3 + 2]}, i));
    readPointData(piece.child("PointData"), points);
    mMesh.normals.resize(mMesh.positions.size(), glm::vec3(0.0f));  // what has none gets the triangles'
    readCells(piece, "Polys", "NumberOfPolys", false, first);
    readCells(piece, "Strips", "NumberOfStrips", true, first);
    Faces faces = std::move(mFaces);
    faces.moveInto(mMesh, mPath);
  }

  void readPointData(const XmlElement* data, std::uint64_t points) {
    if (!data) return;
    if (const XmlElement* normals = arrayNamed(data, data->attribute("Normals"))) {
      VtkArray array(mXml, *normals);
      if (array.components() != 3) refuse(mPath, "is damaged: its normals have no three coordinates");
      std::vector<double> n = numbersOf(array, points * 3);
      mMesh.normals.resize(mMesh.positions.size() - points, glm::vec3(0.0f));
      for (std::size_t i = 0; i < points; ++i)
        mMesh.normals.push_back(glm::vec3(glm::dvec3(n[i * 3], n[i * 3 + 1], n[i * 3 + 2])));
    }
    // Bytes of three or four components are what VTK shows as colours.
    const XmlElement* scalars = arrayNamed(data, data->attribute("Scalars"));
    if (!scalars || scalars->attribute("type") != "UInt8") return;
    VtkArray array(mXml, *scalars);
    auto step = std::size_t(array.components());
    if (step != 3 && step != 4) return;
    std::vector<double> c = numbersOf(array, points * step);
    for (std::size_t i = 0; i < c.size(); i += step)
      mColors.add(glm::vec3(glm::dvec3(c[i], c[i + 1], c[i + 2]) / 255.0));
  }

  /// @param first  the number of the piece's first point
  void readCells(const XmlElement& piece, const char* name, const char* key, bool areStrips, std::size_t first) {
    auto cells = std::uint64_t(countIn(piece, key));
    if (cells == 0) return;
    const XmlElement* parent = piece.child(name);
    const XmlElement *corners = arrayNamed(parent, "connectivity"), *ends = arrayNamed(parent, "offsets");
    if (!corners || !ends) refuse(mPath, fmt::format("is damaged: its {} have no connectivity or offsets", name));
    std::vector<double> end = numbersOf(VtkArray(mXml, *ends), cells);
    double last = 0;
    for (double e : end) {
      if (!(e >= last && e < 1e13)) refuse(mPath, fmt::format("is damaged: its {} have offsets that go back", name));
      last = e;
    }
    std::vector<double> corner = numbersOf(VtkArray(mXml, *corners), std::uint64_t(last));
    auto limit = double(mMesh.positions.size() - first);
    std::vector<std::uint32_t> ids;
    std::size_t at = 0;
    for (double e : end) {
      ids.clear();
      for (; at < std::size_t(e); ++at) {
        if (!(corner[at] >= 0 && corner[at] < limit))
          refuse(mPath, fmt::format("a face names point {}, which is not there", corner[at]));
        ids.push_back(std::uint32_t(corner[at]) + std::uint32_t(first));
      }
      areStrips ? mFaces.addStrip(ids) : mFaces.add(ids);
    }
  }

  const Path& mPath;
  VtkXml mXml;
  Progress& mProgress;
  Mesh mMesh;
  Faces mFaces;
  ColorTally mColors;
  double mTaken = 0;  ///< Bytes of all arrays so far.
};

}  // namespace

Mesh readVtp(const Path& path, Progress& progress) {
  FileBytes file(path);
  return VtpReader(file, progress).read();
}

}  // namespace velum::io
