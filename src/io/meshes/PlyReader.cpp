#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "core/Text.h"
#include "io/meshes/MeshParts.h"
#include "io/meshes/MeshReaders.h"
#include "io/meshes/PlyHeader.h"

/// Read by us and not by VTK, whose reader believes what it meets: it writes behind its buffers when a last newline or
/// a list is missing.
namespace velum::io {

namespace {

/// Values of the body, one after the other. A place in a file in memory.
class PlyBody {
 public:
  PlyBody(std::string_view file, const PlyHeader& header, const Path& path)
      : mRest(file.substr(header.bodyAt)),
        mIsText(header.isText),
        mSwaps(header.isBigEndian != (std::endian::native == std::endian::big)),
        mPath(path) {}

  double take(PlyType type) { return mIsText ? takeText() : takeBinary(type); }
  /// Refuses a number of things that what is left cannot hold.
  void checkRoom(double count, std::size_t bytesEach, std::string_view what) const {
    // The last number of a text needs no blank behind it.
    if (count * double(bytesEach) > double(mRest.size()) + (mIsText ? 1.0 : 0.0))
      refuse(mPath,
             fmt::format("promises {:.0f} {}, more than the file can hold; it is damaged or cut short", count, what));
  }
  /// The fewest bytes that a value of this type takes.
  std::size_t leastBytes(PlyType type) const { return mIsText ? 2 : sizeOf(type); }

 private:
  double takeText() {
    auto value = takeNumber(mRest);
    if (!value) {
      std::string_view rest = trimmed(mRest.substr(0, 100));
      if (rest.empty()) refuse(mPath, "is cut short");
      refuse(mPath,
             fmt::format("has {} where a number belongs", inQuotes(rest.substr(0, rest.find_first_of(" \r\n")))));
    }
    return *value;
  }
  template <class T>
  double as() {
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), mRest.data(), sizeof(T));
    if (mSwaps) std::reverse(raw.begin(), raw.end());
    return double(std::bit_cast<T>(raw));
  }
  double takeBinary(PlyType type) {
    std::size_t size = sizeOf(type);
    if (mRest.size() < size) refuse(mPath, "is cut short");
    double value = 0;
    switch (type) {
      case PlyType::Int8:
        value = as<std::int8_t>();
        break;
      case PlyType::UInt8:
        value = as<std::uint8_t>();
        break;
      case PlyType::Int16:
        value = as<std::int16_t>();
        break;
      case PlyType::UInt16:
        value = as<std::uint16_t>();
        break;
      case PlyType::Int32:
        value = as<std::int32_t>();
        break;
      case PlyType::UInt32:
        value = as<std::uint32_t>();
        break;
      case PlyType::Float32:
        value = as<float>();
        break;
      case PlyType::Float64:
        value = as<double>();
        break;
    }
    mRest.remove_prefix(size);
    return value;
  }

  std::string_view mRest;
  bool mIsText, mSwaps;
  const Path& mPath;
};

/// What a property is to us: a place in a row of nine numbers (position, normal, colour), or nothing.
int slotOf(std::string_view name) {
  constexpr std::string_view kNames[9] = {"x", "y", "z", "nx", "ny", "nz", "red", "green", "blue"};
  if (name.starts_with("diffuse_")) name.remove_prefix(8);
  auto at = std::find(std::begin(kNames), std::end(kNames), name);
  return at == std::end(kNames) ? -1 : int(at - std::begin(kNames));
}

/// What makes 1 of the brightest colour.
double colorScale(PlyType type) {
  switch (type) {
    case PlyType::UInt8:
      return 1 / 255.0;
    case PlyType::UInt16:
      return 1 / 65535.0;
    default:
      return 1.0;
  }
}

class PlyReader {
 public:
  PlyReader(std::string_view file, const Path& path, Progress& progress)
      : mPath(path), mProgress(progress), mHeader(parsePlyHeader(file, path)), mBody(file, mHeader, path) {}

  Mesh read() {
    for (const PlyElement& element : mHeader.elements)
      if (element.name == "vertex") mPoints = double(element.count);
    for (const PlyElement& element : mHeader.elements) readElement(element);
    if (mMesh.positions.empty()) refuse(mPath, "has no points");
    if (!mHasFaces) refuse(mPath, "has points but no faces; a cloud of points is no surface");
    mFaces.moveInto(mMesh, mPath);
    mColors.putInto(mMesh);
    return std::move(mMesh);
  }

 private:
  /// A row of numbers, and the corners that a list among them names.
  struct Row {
    std::array<double, 9> numbers{};
    std::vector<std::uint32_t> corners;
  };

  void readElement(const PlyElement& element) {
    bool isVertex = element.name == "vertex", isStrip = element.name == "tristrips", isFace = element.name == "face";
    if (isFace || isStrip) checkCorners(element);
    if (element.properties.empty()) return;
    std::size_t least = 0;
    for (const PlyProperty& p : element.properties) least += mBody.leastBytes(p.countType.value_or(p.type));
    mBody.checkRoom(double(element.count), least, element.name + " elements");
    std::vector<int> slots;
    for (const PlyProperty& p : element.properties) slots.push_back(p.countType ? -1 : slotOf(p.name));
    auto has = [&](int slot) { return std::find(slots.begin(), slots.end(), slot) != slots.end(); };
    if (isVertex && !(has(0) && has(1) && has(2))) refuse(mPath, "its points have no x, y or z");
    mLeastCorner = isStrip ? -1 : 0;
    mHasNormals = has(3) && has(4) && has(5);
    mHasColors = has(6) && has(7) && has(8);
    Row row;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (i % 65536 == 0) mProgress.report(double(i) / double(element.count), "reading surface");
      readRow(element, slots, isFace || isStrip, row);
      if (isVertex) addPoint(row);
      if (isFace) mFaces.add(row.corners);
      if (isStrip) addStrips(row.corners);
      if (isFace && mHasColors) addColor(row);
    }
  }

  void checkCorners(const PlyElement& element) {
    auto isCorners = [](const PlyProperty& p) { return p.countType && isCornerList(p.name); };
    if (element.count > 0 && std::none_of(element.properties.begin(), element.properties.end(), isCorners))
      refuse(mPath, "its faces name no points: the list 'vertex_indices' is missing");
    mHasFaces = true;
  }
  static bool isCornerList(std::string_view name) { return name == "vertex_indices" || name == "vertex_index"; }

  void readRow(const PlyElement& element, const std::vector<int>& slots, bool hasCorners, Row& row) {
    row.corners.clear();
    for (std::size_t i = 0; i < slots.size(); ++i) {
      const PlyProperty& p = element.properties[i];
      if (p.countType) {
        readList(p, hasCorners && isCornerList(p.name), row);
        continue;
      }
      double value = mBody.take(p.type);
      if (slots[i] >= 0) row.numbers[std::size_t(slots[i])] = slots[i] >= 6 ? value * colorScale(p.type) : value;
    }
  }

  void readList(const PlyProperty& p, bool areCorners, Row& row) {
    double count = mBody.take(*p.countType);
    if (!(count >= 0)) refuse(mPath, fmt::format("has a list of {:.0f} items", count));
    mBody.checkRoom(count, mBody.leastBytes(p.type), "items in a list");
    for (double i = 0; i < count; ++i) {
      double item = mBody.take(p.type);
      if (!areCorners) continue;
      if (!(item >= mLeastCorner && item < mPoints) || item != std::floor(item))
        refuse(mPath, fmt::format("a face names point {}, which is not there", item));
      row.corners.push_back(item < 0 ? kEnd : std::uint32_t(item));
    }
  }

  void addPoint(const Row& row) {
    const auto& n = row.numbers;
    mMesh.positions.push_back(pointOf(mPath, {n[0], n[1], n[2]}, mMesh.positions.size()));
    if (mHasNormals) mMesh.normals.push_back(glm::vec3(glm::dvec3(n[3], n[4], n[5])));
    if (mHasColors) addColor(row);
  }
  void addColor(const Row& row) { mColors.add(glm::vec3(glm::dvec3(row.numbers[6], row.numbers[7], row.numbers[8]))); }

  /// -1 stands between strips.
  void addStrips(std::span<const std::uint32_t> corners) {
    for (;;) {
      auto end = std::find(corners.begin(), corners.end(), kEnd);
      auto count = std::size_t(end - corners.begin());
      mFaces.addStrip(corners.first(count));
      if (end == corners.end()) return;
      corners = corners.subspan(count + 1);
    }
  }

  /// Where a strip ends.
  static constexpr std::uint32_t kEnd = 0xffffffff;

  const Path& mPath;
  Progress& mProgress;
  PlyHeader mHeader;
  PlyBody mBody;
  Mesh mMesh;
  Faces mFaces;
  ColorTally mColors;
  double mPoints = 0, mLeastCorner = 0;
  bool mHasNormals = false, mHasColors = false, mHasFaces = false;
};

}  // namespace

Mesh readPly(const Path& path, Progress& progress) {
  std::vector<char> file = contentOf(path);
  return PlyReader({file.data(), file.size()}, path, progress).read();
}

}  // namespace velum::io
