#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/Text.h"
#include "io/meshes/MeshParts.h"
#include "io/meshes/MeshReaders.h"

/// Wavefront OBJ: its points, normals and faces. What else it has (textures, materials, groups, curves) is passed over.
namespace velum::io {

namespace {

constexpr std::uint32_t kNone = 0xffffffff;
constexpr std::string_view kBlanks = " \t\r";

struct Corner {
  std::uint32_t point = 0, normal = kNone;
};

class ObjReader {
 public:
  ObjReader(std::string_view text, const Path& path, Progress& progress)
      : mText(text), mRest(text), mPath(path), mProgress(progress) {}

  Mesh read() {
    std::string joined;
    for (std::size_t lines = 0; !mRest.empty(); ++lines) {
      if (lines % 65536 == 0) mProgress.report(1.0 - double(mRest.size()) / double(mText.size()), "reading surface");
      readLine(takeLine(joined));
    }
    mColors.putInto(mMesh);
    makeFaces();
    return std::move(mMesh);
  }

 private:
  /// The next line; where it ends in a backslash, with those behind it, in @p joined.
  std::string_view takeLine(std::string& joined) {
    joined.clear();
    for (;;) {
      std::size_t end = std::min(mRest.find('\n'), mRest.size());
      std::string_view line = mRest.substr(0, end);
      mRest.remove_prefix(std::min(end + 1, mRest.size()));
      while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
      bool goesOn = line.ends_with('\\');
      if (goesOn) line.remove_suffix(1);
      if (!goesOn && joined.empty()) return line;
      joined.append(line);
      if (goesOn) joined += ' ';
      if (!goesOn || mRest.empty()) return joined;
    }
  }

  void readLine(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
    std::string_view key = line.substr(0, line.find_first_of(kBlanks));
    std::string_view rest = line.substr(key.size());
    if (key == "v") readPoint(rest);
    if (key == "vn") mNormals.push_back(glm::vec3(takeThree(rest)));
    if (key == "f" || key == "fo") readFace(rest);
  }

  glm::dvec3 takeThree(std::string_view& rest) const {
    glm::dvec3 p;
    for (int i = 0; i < 3; ++i) {
      auto number = takeNumber(rest);
      if (!number)
        refuse(mPath, fmt::format("is damaged: point or normal {} has no three numbers", mMesh.positions.size() + 1));
      p[i] = *number;
    }
    return p;
  }

  /// "v x y z", with a weight or a colour behind.
  void readPoint(std::string_view rest) {
    glm::dvec3 p = takeThree(rest);
    mMesh.positions.push_back(pointOf(mPath, p, mMesh.positions.size() + 1));
    double more[4] = {};
    int count = 0;
    for (; count < 4; ++count) {
      auto number = takeNumber(rest);
      if (!number) break;
      more[count] = *number;
    }
    if (count == 3) mColors.add(glm::vec3(glm::dvec3(more[0], more[1], more[2])));
  }

  /// "f 1/2/3 4//5 -1": point, texture, normal; from 1, or backwards from the last.
  void readFace(std::string_view rest) {
    std::size_t start = mCorners.size();
    for (;;) {
      rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
      if (rest.empty()) break;
      Corner corner{takeIndex(rest, mMesh.positions.size()), kNone};
      if (rest.starts_with('/')) {
        rest.remove_prefix(1);
        if (!rest.starts_with('/') && !rest.empty() && kBlanks.find(rest[0]) == kBlanks.npos) takeInteger(rest);
        if (rest.starts_with('/') && rest.size() > 1 && kBlanks.find(rest[1]) == kBlanks.npos) {
          rest.remove_prefix(1);
          corner.normal = takeIndex(rest, mNormals.size());
        } else if (rest.starts_with('/')) {
          rest.remove_prefix(1);
        }
      }
      mCorners.push_back(corner);
    }
    mSizes.push_back(std::uint32_t(mCorners.size() - start));
  }

  std::int64_t takeInteger(std::string_view& rest) const {
    std::int64_t value = 0;
    auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    if (error != std::errc())
      refuse(mPath,
             fmt::format("is damaged: a face has {} where a point's number belongs", inQuotes(rest.substr(0, 20))));
    rest.remove_prefix(std::size_t(end - rest.data()));
    return value;
  }
  std::uint32_t takeIndex(std::string_view& rest, std::size_t known) const {
    std::int64_t value = takeInteger(rest);
    std::int64_t index = value < 0 ? std::int64_t(known) + value : value - 1;
    if (index < 0 || index >= std::int64_t(kNone))
      refuse(mPath, fmt::format("a face names point or normal {}, which is not there", value));
    return std::uint32_t(index);
  }

  /// A point with two normals becomes two. Normals that only some corners have are left out.
  void makeFaces() {
    bool hasNormals = !mCorners.empty();
    for (const Corner& corner : mCorners) {
      hasNormals = hasNormals && corner.normal != kNone;
      if (corner.point >= mMesh.positions.size())
        refuse(mPath, fmt::format("a face names point {}, which is not there", corner.point + 1));
      if (corner.normal != kNone && corner.normal >= mNormals.size())
        refuse(mPath, fmt::format("a face names normal {}, which is not there", corner.normal + 1));
    }
    if (hasNormals) splitPoints();
    Faces faces;
    std::vector<std::uint32_t> points;
    std::size_t at = 0;
    for (std::uint32_t size : mSizes) {
      points.clear();
      for (std::size_t i = 0; i < size; ++i) points.push_back(mCorners[at++].point);
      faces.add(points);
    }
    faces.moveInto(mMesh, mPath);
  }

  void splitPoints() {
    std::vector<std::uint32_t> firstNormal(mMesh.positions.size(), kNone);
    std::unordered_map<std::uint64_t, std::uint32_t> others;
    mMesh.normals.resize(mMesh.positions.size(), glm::vec3(0.0f));
    for (Corner& corner : mCorners) {
      std::uint32_t& first = firstNormal[corner.point];
      if (first == kNone) {
        first = corner.normal;
        mMesh.normals[corner.point] = mNormals[corner.normal];
      }
      if (first == corner.normal) continue;
      std::uint64_t key = std::uint64_t(corner.point) << 32 | corner.normal;
      auto [other, isNew] = others.try_emplace(key, std::uint32_t(mMesh.positions.size()));
      if (isNew) {
        mMesh.positions.push_back(glm::vec3(mMesh.positions[corner.point]));
        mMesh.normals.push_back(mNormals[corner.normal]);
      }
      corner.point = other->second;
    }
  }

  std::string_view mText, mRest;
  const Path& mPath;
  Progress& mProgress;
  Mesh mMesh;
  std::vector<glm::vec3> mNormals;
  std::vector<Corner> mCorners;
  std::vector<std::uint32_t> mSizes;  ///< Corners of each face.
  ColorTally mColors;
};

}  // namespace

Mesh readObj(const Path& path, Progress& progress) {
  std::vector<char> file = contentOf(path);
  return ObjReader({file.data(), file.size()}, path, progress).read();
}

}  // namespace velum::io
