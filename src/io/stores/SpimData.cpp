#include "io/stores/SpimData.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "core/Error.h"
#include "core/Text.h"
#include "io/read/FileNames.h"
#include "io/read/XmlTree.h"

namespace velum::io {

namespace {

constexpr std::size_t kMostTimePoints = 1'000'000;
constexpr std::uint64_t kMostText = 1 << 20;

/// Reads the elements of the file.
class SpimReader {
 public:
  explicit SpimReader(const Path& path) : mPath(path), mFile(path), mRoot(readXml(mFile, "")) {}

  SpimData read() {
    const XmlElement* sequence = mRoot.child("SequenceDescription");
    if (mRoot.name != "SpimData" || !sequence) refuse(mPath, "is no XML of BigDataViewer: it has no sequence of views");
    readSetups(childOf(*sequence, "ViewSetups"));
    readTimePoints(sequence->child("Timepoints"));
    if (const XmlElement* registrations = mRoot.child("ViewRegistrations"))
      for (const XmlElement& one : registrations->children) readRegistration(one);
    readLoader(childOf(*sequence, "ImageLoader"));
    return std::move(mData);
  }

 private:
  const XmlElement& childOf(const XmlElement& of, const char* name) const {
    const XmlElement* child = of.child(name);
    if (!child) refuse(mPath, fmt::format("its <{}> lacks <{}>", of.name, name));
    return *child;
  }

  std::string text(const XmlElement& element) const {
    if (element.textEnd <= element.textAt) return {};
    std::string all(std::size_t(std::min(element.textEnd - element.textAt, kMostText)), '\0');
    mFile.read(element.textAt, std::as_writable_bytes(std::span(all)));
    std::size_t first = all.find_first_not_of(" \t\r\n"), last = all.find_last_not_of(" \t\r\n");
    return first == all.npos ? std::string() : all.substr(first, last - first + 1);
  }
  std::string textOf(const XmlElement& of, const char* name) const {
    const XmlElement* child = of.child(name);
    return child ? text(*child) : std::string();
  }

  int whole(std::string_view words, std::string_view what) const {
    int number = 0;
    auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), number);
    if (error != std::errc() || end != words.data() + words.size() || number < 0)
      refuse(mPath, fmt::format("{} is no number but {}", what, inQuotes(words)));
    return number;
  }

  std::vector<double> numbers(const std::string& words) const {
    std::vector<double> all;
    std::istringstream in(words);
    for (std::string word; in >> word;) all.push_back(numberIn(word).value_or(NAN));
    return all;
  }
  std::optional<glm::dvec3> three(const std::string& words) const {
    auto all = numbers(words);
    if (all.size() != 3 || !std::isfinite(all[0] + all[1] + all[2])) return std::nullopt;
    return glm::dvec3(all[0], all[1], all[2]);
  }

  void readSetups(const XmlElement& setups) {
    for (const XmlElement& element : setups.children) {
      if (element.name == "Attributes") readNames(element);
      if (element.name != "ViewSetup") continue;
      SpimData::Setup setup;
      setup.id = whole(textOf(element, "id"), "the id of a view setup");
      setup.name = textOf(element, "name");
      if (auto size = three(textOf(element, "size")); size && glm::all(glm::lessThan(*size, glm::dvec3(2e9))))
        setup.size = glm::ivec3(*size);
      if (const XmlElement* voxel = element.child("voxelSize")) {
        setup.unit = textOf(*voxel, "unit");
        setup.voxelSize = three(textOf(*voxel, "size"));
      }
      if (const XmlElement* attributes = element.child("attributes"))
        for (const XmlElement& one : attributes->children) setup.attributes[one.name] = text(one);
      mData.setups.push_back(std::move(setup));
    }
    if (mData.setups.empty()) refuse(mPath, "it has no view setups");
  }

  /// What channels, tiles, angles and illuminations are called.
  void readNames(const XmlElement& attributes) {
    std::string kind(attributes.attribute("name"));
    for (const XmlElement& one : attributes.children)
      if (std::string name = textOf(one, "name"); !name.empty()) mData.names[{kind, textOf(one, "id")}] = name;
  }

  void addTimePoints(int first, int last, int step) {
    for (std::int64_t i = first; i <= last && mData.timePoints.size() < kMostTimePoints; i += std::max(step, 1))
      mData.timePoints.push_back(int(i));
  }

  /// "range" has first and last; "pattern" is "0-9", "0-8:2, 11"; "list" has elements.
  void readTimePoints(const XmlElement* element) {
    if (element && element->child("first"))
      addTimePoints(whole(textOf(*element, "first"), "the first time point"),
                    whole(textOf(*element, "last"), "the last time point"), 1);
    else if (element && element->child("integerpattern"))
      addPattern(textOf(*element, "integerpattern"));
    else if (element)
      for (const XmlElement& one : element->children)
        if (one.name == "Timepoint" && mData.timePoints.size() < kMostTimePoints)
          mData.timePoints.push_back(whole(textOf(one, "id"), "the id of a time point"));
    if (mData.timePoints.empty()) mData.timePoints = {0};
  }

  void addPattern(std::string pattern) {
    std::replace(pattern.begin(), pattern.end(), ',', ' ');
    std::istringstream in(pattern);
    for (std::string part; in >> part;) {
      std::string_view left = part;
      int step = 1;
      if (std::size_t colon = left.find(':'); colon != left.npos) {
        step = whole(left.substr(colon + 1), "a step of time points");
        left = left.substr(0, colon);
      }
      std::size_t dash = left.find('-');
      int first = whole(left.substr(0, dash), "a time point");
      addTimePoints(first, dash == left.npos ? first : whole(left.substr(dash + 1), "a time point"), step);
    }
  }

  /// The product of its transformations: the one that is listed first is applied last.
  void readRegistration(const XmlElement& registration) {
    if (registration.name != "ViewRegistration") return;
    int timePoint = whole(registration.attribute("timepoint"), "the time point of a registration"),
        setup = whole(registration.attribute("setup"), "the setup of a registration");
    glm::dmat4 world(1.0);
    for (const XmlElement& one : registration.children) {
      if (one.name != "ViewTransform") continue;
      if (std::string type(one.attribute("type")); type != "affine")
        refuse(mPath, fmt::format("a transformation of the type {} is not known here; affine is", inQuotes(type)));
      auto rows = numbers(textOf(one, "affine"));
      bool isFit =
          rows.size() == 12 && std::all_of(rows.begin(), rows.end(), [](double x) { return std::isfinite(x); });
      if (!isFit) refuse(mPath, "an affine transformation has not twelve numbers");
      glm::dmat4 matrix(1.0);
      for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) matrix[column][row] = rows[std::size_t(row * 4 + column)];
      world = world * matrix;
    }
    mData.worldFrom[{timePoint, setup}] = world;
  }

  void readLoader(const XmlElement& loader) {
    mData.format = std::string(loader.attribute("format"));
    bool isHdf5 = mData.format == "bdv.hdf5", isN5 = mData.format == "bdv.n5";
    if (!isHdf5 && !isN5)
      refuse(mPath, fmt::format("its voxels are kept as {}, which is not known here; bdv.hdf5 and bdv.n5 are{}",
                                inQuotes(mData.format),
                                mData.format.find("zarr") != mData.format.npos ? "; open the .zarr itself" : ""));
    std::string name = text(childOf(loader, isHdf5 ? "hdf5" : "n5"));
    if (std::string base = textOf(mRoot, "BasePath"); !base.empty()) name = base + "/" + name;
    if (isHdf5) {
      mData.voxels = siblingFile(mPath, name);
      return;
    }
    // Names come from strangers: as files, folders lie in the XML's folder or below.
    Path inside = Path(name).lexically_normal();
    if (name.empty() || inside.is_absolute() || inside.begin()->string() == "..")
      refuse(mPath, fmt::format("the folder {} that it names does not lie beside it", inQuotes(name)));
    mData.voxels = mPath.parent_path() / inside;
    std::error_code error;
    if (!std::filesystem::is_directory(mData.voxels, error))
      refuse(mPath, fmt::format("the folder {} that it names is missing", inQuotes(name)));
  }

  Path mPath;
  FileBytes mFile;
  XmlElement mRoot;
  SpimData mData;
};

}  // namespace

SpimData readSpimData(const Path& xml) { return SpimReader(xml).read(); }

std::optional<SpimData> spimDataBeside(const Path& voxels) {
  Path folder = voxels;
  if (!folder.has_filename()) folder = folder.parent_path();
  Path xml = folder;
  xml.replace_extension(".xml");
  std::error_code error;
  if (!std::filesystem::is_regular_file(xml, error)) return std::nullopt;
  try {
    SpimData data = readSpimData(xml);
    if (std::filesystem::equivalent(data.voxels, folder, error)) return data;
  } catch (const InputError&) {
    // The voxels are what was asked for; what only lies beside them must not hide them.
  }
  return std::nullopt;
}

bool isSpimData(std::string_view head) { return head.find("<SpimData") != head.npos; }

}  // namespace velum::io
