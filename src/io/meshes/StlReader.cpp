#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "core/FileName.h"
#include "core/Text.h"
#include "io/meshes/MeshParts.h"
#include "io/meshes/MeshReaders.h"

/// Triangles without neighbours, as text or binary: equal corners become one point again.
namespace velum::io {

namespace {

constexpr std::size_t kHead = 84, kTriangle = 50;

/// Numbers points by their place: a table of open addresses, kept at most half full.
class Points {
 public:
  explicit Points(std::vector<glm::vec3>& points) : mPoints(points), mTable(1024, kFree) {}

  std::uint32_t indexOf(glm::vec3 p) {
    p += 0.0f;  // makes -0 to 0, so that equal places have equal bytes
    if (mPoints.size() * 2 >= mTable.size()) grow();
    std::size_t slot = slotOf(p);
    if (mTable[slot] == kFree) {
      mTable[slot] = std::uint32_t(mPoints.size());
      mPoints.push_back(p);
    }
    return mTable[slot];
  }

 private:
  static constexpr std::uint32_t kFree = 0xffffffff;

  std::size_t slotOf(const glm::vec3& p) const {
    std::uint64_t hash = 0;
    for (int i = 0; i < 3; ++i) hash = (hash ^ std::bit_cast<std::uint32_t>(p[i])) * 0x9e3779b97f4a7c15;
    std::size_t slot = (hash ^ (hash >> 32)) & (mTable.size() - 1);
    while (mTable[slot] != kFree && mPoints[mTable[slot]] != p) slot = (slot + 1) & (mTable.size() - 1);
    return slot;
  }
  void grow() {
    mTable.assign(mTable.size() * 4, kFree);
    for (std::size_t i = 0; i < mPoints.size(); ++i) mTable[slotOf(mPoints[i])] = std::uint32_t(i);
  }

  std::vector<glm::vec3>& mPoints;
  std::vector<std::uint32_t> mTable;
};

/// What is added triangle by triangle.
class Builder {
 public:
  Builder(const Path& path, Mesh& mesh) : mPath(path), mMesh(mesh), mPoints(mesh.positions) {}

  void add(std::span<const glm::dvec3, 3> corners) {
    std::array<std::uint32_t, 3> ids;
    for (std::size_t i = 0; i < 3; ++i) ids[i] = mPoints.indexOf(pointOf(mPath, corners[i], mCorners++));
    if (ids[0] != ids[1] && ids[1] != ids[2] && ids[0] != ids[2])
      mMesh.indices.insert(mMesh.indices.end(), ids.begin(), ids.end());
  }

 private:
  const Path& mPath;
  Mesh& mMesh;
  Points mPoints;
  std::size_t mCorners = 0;
};

std::uint32_t takeLittle(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

void readBinary(std::string_view file, std::uint32_t triangles, Builder& builder, Progress& progress) {
  for (std::uint32_t t = 0; t < triangles; ++t) {
    if (t % 65536 == 0) progress.report(double(t) / triangles, "reading surface");
    const char* at = file.data() + kHead + std::size_t(t) * kTriangle + 12;  // behind its normal
    std::array<glm::dvec3, 3> corners;
    for (glm::dvec3& corner : corners)
      for (int i = 0; i < 3; ++i, at += 4) corner[i] = double(std::bit_cast<float>(takeLittle(at)));
    builder.add(corners);
  }
}

/// "facet normal x y z  outer loop  vertex x y z ...  endloop  endfacet", between lines "solid ..." and "endsolid ...".
class TextReader {
 public:
  TextReader(std::string_view text, const Path& path, Builder& builder)
      : mText(text), mRest(text), mPath(path), mBuilder(builder) {}

  /// @return true when the last solid has its end
  bool read(Progress& progress) {
    bool isOpen = false;
    for (std::string word; !(word = takeWord()).empty();) {
      if (word == "solid" || word == "endsolid") {
        isOpen = word == "solid";
        mRest.remove_prefix(std::min(mRest.find('\n'), mRest.size()));  // its name
      } else if (word == "facet") {
        progress.report(1.0 - double(mRest.size()) / double(mText.size()), "reading surface");
        readFacet();
      } else if (word != "color") {
        refuseWord(word, "facet");
      } else {
        takePoint();
      }
    }
    return !isOpen;
  }

 private:
  void readFacet() {
    expect("normal");
    takePoint();
    expect("outer");
    expect("loop");
    std::vector<glm::dvec3> corners;
    std::string word;
    while ((word = takeWord()) == "vertex") corners.push_back(takePoint());
    if (word != "endloop") refuseWord(word, "vertex");
    expect("endfacet");
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      mBuilder.add(std::array{corners[0], corners[i], corners[i + 1]});
  }

  std::string takeWord() {
    constexpr std::string_view kBlanks = " \t\r\n";
    mRest.remove_prefix(std::min(mRest.find_first_not_of(kBlanks), mRest.size()));
    std::size_t end = std::min(mRest.find_first_of(kBlanks), mRest.size());
    std::string word = lowerCase(mRest.substr(0, std::min<std::size_t>(end, 64)));
    mRest.remove_prefix(end);
    return word;
  }
  glm::dvec3 takePoint() {
    glm::dvec3 p;
    for (int i = 0; i < 3; ++i) {
      auto number = takeNumber(mRest);
      if (!number) refuseWord(takeWord(), "a number");
      p[i] = *number;
    }
    return p;
  }
  void expect(std::string_view wanted) {
    if (std::string word = takeWord(); word != wanted) refuseWord(word, wanted);
  }
  [[noreturn]] void refuseWord(const std::string& word, std::string_view wanted) const {
    if (word.empty()) refuse(mPath, "is cut short");
    refuse(mPath, fmt::format("is damaged, or no STL file: it has {} where {} belongs", inQuotes(word), wanted));
  }

  std::string_view mText, mRest;
  const Path& mPath;
  Builder& mBuilder;
};

}  // namespace

Mesh readStl(const Path& path, Progress& progress) {
  std::vector<char> bytes = contentOf(path);
  std::string_view file(bytes.data(), bytes.size());
  std::uint32_t triangles = file.size() >= kHead ? takeLittle(file.data() + 80) : 0;
  std::uint64_t needed = kHead + std::uint64_t(triangles) * kTriangle;
  // Some binary files begin with "solid", too; then their length tells.
  std::string_view start = trimmed(file.substr(0, kHead));
  bool isText = lowerCase(start.substr(0, 5)) == "solid" && (file.size() < kHead || needed != file.size());
  Mesh mesh;
  Builder builder(path, mesh);
  if (isText) {
    if (!TextReader(file, path, builder).read(progress))
      mesh.warnings.push_back("its last solid has no end; the file may be cut short");
    return mesh;
  }
  if (file.size() < kHead) refuse(path, "is cut short, or no STL file");
  if (needed > file.size())
    refuse(path,
           fmt::format("promises {} triangles, more than the file can hold; it is damaged or cut short", triangles));
  readBinary(file, triangles, builder, progress);
  return mesh;
}

}  // namespace velum::io
