#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>

#include "core/Error.h"
#include "core/Text.h"
#include "io/read/FileBytes.h"
#include "io/read/Placement.h"
#include "io/read/SampleBytes.h"
#include "io/volumes/Readers.h"

/// Legacy .vtk files with STRUCTURED_POINTS. Read by us and not by VTK, whose reader allocates whatever the header says
/// and holds the voxels twice; the format is a few lines of text and big-endian numbers.
namespace velum::io {

namespace {

constexpr std::size_t kHead = 1u << 16;

struct Header {
  bool isAscii = false, isCellData = false;
  glm::dvec3 dims{0.0}, spacing{1.0}, origin{0.0};
  SampleType type = SampleType::UInt8;
  bool isWide = false;  ///< 64-bit integers, read as doubles.
  double components = 1;
  std::string title;
  std::size_t dataAt = 0;
};

/// Words of the head, with the place of the next byte.
class Words {
 public:
  explicit Words(std::string_view text) : mText(text) {}

  std::string_view line() {
    std::size_t end = std::min(mText.find('\n', mAt), mText.size());
    auto out = mText.substr(mAt, end - mAt);
    mAt = std::min(end + 1, mText.size());
    if (!out.empty() && out.back() == '\r') out.remove_suffix(1);
    return out;
  }
  std::string next() {
    while (mAt < mText.size() && std::isspace(static_cast<unsigned char>(mText[mAt]))) ++mAt;
    std::size_t from = mAt;
    while (mAt < mText.size() && !std::isspace(static_cast<unsigned char>(mText[mAt]))) ++mAt;
    std::string word(mText.substr(from, mAt - from));
    for (char& c : word) c = char(std::tolower(static_cast<unsigned char>(c)));
    return word;
  }
  double number() {
    std::string word = next();
    std::string_view rest = word;
    return takeNumber(rest).value_or(std::nan(""));
  }
  std::size_t at() const { return mAt; }

 private:
  std::string_view mText;
  std::size_t mAt = 0;
};

void setType(Header& h, std::string_view name, const Path& path) {
  constexpr std::pair<std::string_view, SampleType> kTypes[] = {
      {"unsigned_char", SampleType::UInt8},   {"char", SampleType::Int8},           {"signed_char", SampleType::Int8},
      {"unsigned_short", SampleType::UInt16}, {"short", SampleType::Int16},         {"int", SampleType::Int32},
      {"unsigned_int", SampleType::UInt32},   {"float", SampleType::Float32},       {"double", SampleType::Float64},
      {"long", SampleType::Float64},          {"vtktypeint64", SampleType::Float64}};
  for (auto [known, type] : kTypes)
    if (known == name) {
      h.type = type;
      h.isWide = type == SampleType::Float64 && name != "double";
      return;
    }
  refuse(path, fmt::format("samples of type '{}' are not read", name));
}

/// What SCALARS says; a LOOKUP_TABLE line may follow.
void readScalars(Header& h, Words& words, std::string_view text, const Path& path) {
  words.next();  // its name
  setType(h, words.next(), path);
  std::string_view rest = words.line();
  h.components = takeNumber(rest).value_or(1.0);
  Words ahead(text.substr(words.at()));
  if (ahead.next() == "lookup_table") words.line();
}

Header parseHeader(std::string_view text, const Path& path) {
  Words words(text);
  Header h;
  if (!words.line().starts_with("# vtk DataFile")) refuse(path, "is not a legacy VTK file");
  h.title = std::string(words.line().substr(0, 256));
  // Three lines say what the file is.
  std::string encoding = words.next();
  if (encoding != "ascii" && encoding != "binary") refuse(path, fmt::format("an encoding '{}' is not known", encoding));
  h.isAscii = encoding == "ascii";
  words.next();
  std::string kind = words.next();
  if (kind != "structured_points") refuse(path, fmt::format("holds a '{}', not STRUCTURED_POINTS", kind));
  // Then keys in any order, up to the values to be shown: the data stands behind them.
  for (;;) {
    std::string key = words.next();
    if (key.empty()) refuse(path, "has no SCALARS to show");
    glm::dvec3* three = key == "dimensions"                         ? &h.dims
                        : key == "origin"                           ? &h.origin
                        : key == "spacing" || key == "aspect_ratio" ? &h.spacing
                                                                    : nullptr;
    if (three)
      for (int i = 0; i < 3; ++i) (*three)[i] = words.number();
    if (key == "point_data" || key == "cell_data") {
      h.isCellData = key == "cell_data";
      words.number();
    }
    if (key == "scalars") readScalars(h, words, text, path);
    if (key == "color_scalars") {
      words.next();
      h.components = words.number();
      h.type = h.isAscii ? SampleType::Float32 : SampleType::UInt8;
      words.line();
    }
    if (key == "vectors" || key == "normals") {
      words.next();
      setType(h, words.next(), path);
      h.components = 3;
      words.line();
    }
    if (key == "field") {
      words.next(), words.number(), words.next();
      h.components = words.number();
      words.number();  // tuples: the dimensions say it
      setType(h, words.next(), path);
      words.line();
    }
    if (key == "scalars" || key == "color_scalars" || key == "vectors" || key == "normals" || key == "field") break;
  }
  h.dataAt = words.at();
  return h;
}

template <class T>
T sampleFrom(double value) {
  if constexpr (std::is_floating_point_v<T>) return T(value);
  using Limits = std::numeric_limits<T>;
  return T(std::clamp(value, double(Limits::lowest()), double(Limits::max())));
}

/// Numbers as text, in bites of a few MiB.
void readAscii(const FileBytes& file, std::uint64_t at, Volume& v, std::size_t count, const Path& path,
               Progress& progress) {
  std::string bite;
  std::size_t place = 0;
  for (std::size_t done = 0; done < count;) {
    // Refill when the next number may be cut in two; 64 characters hold any number.
    if (bite.size() - place < 64 && at < file.size()) {
      bite.erase(0, place);
      place = 0;
      std::size_t old = bite.size(), more = std::size_t(std::min<std::uint64_t>(1u << 22, file.size() - at));
      bite.resize(old + more);
      file.read(at, std::as_writable_bytes(std::span(bite).subspan(old)));
      at += more;
      progress.report(double(done) / double(count), "reading numbers");
    }
    while (place < bite.size() && std::isspace(static_cast<unsigned char>(bite[place]))) ++place;
    if (place == bite.size() && at < file.size()) continue;
    double value = 0;
    auto [end, error] = std::from_chars(bite.data() + place, bite.data() + bite.size(), value);
    if (error == std::errc::invalid_argument)
      refuse(path, fmt::format("has {} numbers where {} are needed", done, count));
    place = std::size_t(end - bite.data());
    visitSamples(v, [&](auto* p) {
      using T = std::remove_cvref_t<decltype(*p)>;
      reinterpret_cast<T*>(v.voxels.data())[done] = sampleFrom<T>(value);
    });
    ++done;
  }
}

void readBinary(const FileBytes& file, const Header& h, Volume& v) {
  file.read(h.dataAt, v.voxels);
  toMachineOrder(v.voxels, sampleSize(v.type), true);
  if (!h.isWide) return;
  for (std::size_t at = 0; at < v.voxels.size(); at += 8) {
    std::int64_t raw;
    std::memcpy(&raw, v.voxels.data() + at, 8);
    auto value = double(raw);
    std::memcpy(v.voxels.data() + at, &value, 8);
  }
}

}  // namespace

Volume readVtkLegacy(const scene::Source& source, Progress& progress) {
  const Path path = source.path;
  progress.report(0, "reading VTK structured points");
  FileBytes file(path);
  Header h = parseHeader(file.head(kHead), path);
  Volume v;
  if (h.isCellData) {
    h.dims = glm::max(h.dims - 1.0, glm::dvec3(1.0));
    h.origin += h.spacing * 0.5;
    v.warnings.push_back("the values stand in cells; each cell is taken as a voxel");
  }
  for (int i = 0; i < 3; ++i)
    if (!(std::abs(h.spacing[i]) > 0 && std::abs(h.spacing[i]) < 1e9 && std::abs(h.origin[i]) < 1e12 &&
          h.dims[i] == std::floor(h.dims[i])))
      refuse(path, fmt::format("dimension {:.6g}, spacing {:.6g} or origin {:.6g} makes no sense", h.dims[i],
                               h.spacing[i], h.origin[i]));
  v.type = h.type;
  // Text needs a digit and a space for each number, but the last.
  auto stored = double(file.size() - std::min<std::uint64_t>(h.dataAt, file.size()));
  double most = h.isAscii ? (stored + 1) / 2 * double(sampleSize(v.type)) : stored;
  std::size_t bytes = checkedBytes(path, h.dims, h.components, 1, sampleSize(v.type), most);
  v.dims = glm::ivec3(h.dims);
  v.channels = int(h.components);
  v.voxels.resize(bytes);
  if (h.isAscii)
    readAscii(file, h.dataAt, v, bytes / sampleSize(v.type), path, progress);
  else
    readBinary(file, h, v);
  if (h.isWide) v.warnings.push_back("64-bit integers are read as doubles");
  v.isColor = (v.channels == 3 || v.channels == 4) && v.type == SampleType::UInt8;
  v.worldFromVoxel = gridMatrix(h.spacing, h.origin);
  v.isOrientationKnown = false;
  progress.report(1, "reading VTK structured points");
  return v;
}

}  // namespace velum::io
