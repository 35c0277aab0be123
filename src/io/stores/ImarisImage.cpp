#include "io/stores/ImarisImage.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <sstream>

#include "core/Text.h"
#include "io/read/Placement.h"
#include "io/stores/Hdf5Array.h"
#include "io/stores/PlaceLevels.h"

namespace velum::io {

namespace {

constexpr std::size_t kMostImarisChannels = 4096, kMostImarisTimePoints = 1'000'000;

std::string without(std::string_view blanks, std::string text) {
  text.erase(std::find(text.begin(), text.end(), '\0'), text.end());
  while (!text.empty() && blanks.find(text.back()) != blanks.npos) text.pop_back();
  return text;
}

/// "2021-03-01 10:00:00.000" in seconds.
std::optional<double> secondsIn(const std::string& text) {
  std::tm date{};
  double seconds = 0;
  if (std::sscanf(text.c_str(), "%d-%d-%d %d:%d:%lf", &date.tm_year, &date.tm_mon, &date.tm_mday, &date.tm_hour,
                  &date.tm_min, &seconds) != 6)
    return std::nullopt;
  date.tm_year -= 1900;
  date.tm_mon -= 1;
  return double(::timegm(&date)) + seconds;
}

/// Reads one image of a file.
class ImarisReader {
 public:
  ImarisReader(std::shared_ptr<const Hdf5File> file, std::string data)
      : mFile(std::move(file)), mData(std::move(data)), mInfo(mData) {
    mInfo.insert(std::string_view("DataSet").size(), "Info");  // "DataSetInfo1" of "DataSet1"
  }

  ArrayPyramid read() {
    Volume& head = mPyramid.head;
    head.timeSteps = countOf(mData + "/ResolutionLevel 0", "TimePoint", kMostImarisTimePoints);
    head.channels = countOf(mData + "/ResolutionLevel 0/TimePoint 0", "Channel", kMostImarisChannels);
    int levels = countOf(mData, "ResolutionLevel", kMostLevels);
    std::vector<glm::dmat4> places;
    for (int level = 0; level < levels; ++level) places.push_back(addLevel(level));
    head.name = without(" \t\r\n", textOf("Image", "Name").value_or(""));
    std::string unit = without(" ", textOf("Image", "Unit").value_or("um"));
    placeLevels(mPyramid, places, unit);
    head.modality = Modality::Microscopy;
    describeChannels();
    describeTime();
    mPyramid.facts.axes = "t c z y x";
    mPyramid.open = [file = mFile, data = mData](int level, int channel, int timeStep) {
      return openArray(*file, arrayName(data, level, channel, timeStep));
    };
    return std::move(mPyramid);
  }

 private:
  static std::string groupName(const std::string& data, int level, int channel, int timeStep) {
    return fmt::format("{}/ResolutionLevel {}/TimePoint {}/Channel {}", data, level, timeStep, channel);
  }
  static std::string arrayName(const std::string& data, int level, int channel, int timeStep) {
    return groupName(data, level, channel, timeStep) + "/Data";
  }

  /// How many of "TimePoint 0", "TimePoint 1", ... a group holds.
  int countOf(const std::string& group, std::string_view word, std::size_t most) const {
    auto names = mFile->names(group);
    auto count = std::size_t(std::count_if(names.begin(), names.end(), [&](const std::string& name) {
      return name.starts_with(word) && name.size() > word.size() && name[word.size()] == ' ';
    }));
    if (count < 1 || count > most) refuse(mFile->path() / group, fmt::format("holds {} of {}", count, inQuotes(word)));
    return int(count);
  }

  std::optional<std::string> textOf(const std::string& group, const std::string& attribute) const {
    return mFile->text(mInfo + "/" + group, attribute);
  }
  static std::vector<double> numbersIn(const std::optional<std::string>& text) {
    std::vector<double> numbers;
    std::istringstream in(without("", text.value_or("")));
    for (std::string word; in >> word;) numbers.push_back(numberIn(word).value_or(NAN));
    return numbers;
  }
  static std::optional<double> numberOf(const std::optional<std::string>& text) {
    auto numbers = numbersIn(text);
    return numbers.size() == 1 && std::isfinite(numbers[0]) ? std::optional(numbers[0]) : std::nullopt;
  }

  /// Arrays are padded to whole chunks; how much of them counts is said beside. @return the level's place
  glm::dmat4 addLevel(int level) {
    auto array = openArray(*mFile, arrayName(mData, level, 0, 0));
    if (!array) refuse(mFile->path() / arrayName(mData, level, 0, 0), "is missing");
    glm::ivec3 dims(0);
    glm::dvec3 low(0.0), high(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      std::string letter(1, "XYZ"[axis]);
      auto size = numberOf(mFile->text(groupName(mData, level, 0, 0), "ImageSize" + letter));
      if (!size && level == 0) size = numberOf(textOf("Image", letter));
      if (size && *size >= 1 && *size < 2e9) dims[axis] = int(*size);
      low[axis] = numberOf(textOf("Image", fmt::format("ExtMin{}", axis))).value_or(0.0);
      high[axis] = numberOf(textOf("Image", fmt::format("ExtMax{}", axis))).value_or(NAN);
    }
    mPyramid.levels.push_back(levelOf(*array, dims));
    mPyramid.facts.levels.push_back(storedAs(*array, arrayName(mData, level, 0, 0)));
    if (level == 0) mPyramid.head.type = sampleTypeOf(array->type);
    // Extents are those of the borders, not of the voxels' centres.
    glm::dvec3 spacing = (high - low) / glm::dvec3(mPyramid.levels.back().dims);
    bool isPlaced = std::isfinite(spacing.x + spacing.y + spacing.z);
    if (isPlaced) return gridMatrix(spacing, low + 0.5 * spacing);
    return finestFromLevel(factorFromDims(mPyramid.levels.front().dims, mPyramid.levels.back().dims));
  }

  void describeChannels() {
    Volume& head = mPyramid.head;
    std::vector<glm::vec3> colors;
    std::vector<glm::dvec2> windows;
    for (int channel = 0; channel < head.channels; ++channel) {
      std::string group = fmt::format("Channel {}", channel);
      std::string name = without(" \t\r\n", textOf(group, "Name").value_or(""));
      head.channelNames.push_back(name.empty() ? group : name);
      auto color = numbersIn(textOf(group, "Color")), window = numbersIn(textOf(group, "ColorRange"));
      if (color.size() == 3) colors.push_back(glm::clamp(glm::vec3(color[0], color[1], color[2]), 0.0f, 1.0f));
      if (window.size() == 2 && window[0] < window[1]) windows.push_back({window[0], window[1]});
    }
    bool isNamed = head.channels > 1 || mFile->has(mInfo + "/Channel 0");
    if (!isNamed) head.channelNames.clear();
    if (colors.size() == std::size_t(head.channels)) head.channelColors = colors;
    if (windows.size() == std::size_t(head.channels)) mPyramid.channelWindows = windows;
  }

  void describeTime() {
    if (mPyramid.head.timeSteps < 2) return;
    auto at = [&](int step) { return secondsIn(textOf("TimeInfo", fmt::format("TimePoint{}", step)).value_or("")); };
    int last = mPyramid.head.timeSteps;
    if (auto from = at(1), to = at(last); from && to && *to > *from)
      mPyramid.head.timeStepSeconds = (*to - *from) / (last - 1);
  }

  std::shared_ptr<const Hdf5File> mFile;
  std::string mData, mInfo;
  ArrayPyramid mPyramid;
};

}  // namespace

bool isImaris(const Hdf5File& file) { return file.has("DataSet/ResolutionLevel 0"); }

std::vector<StoreImage> listImarisImages(const Hdf5File& file) {
  std::vector<StoreImage> images;
  for (const std::string& name : file.names("")) {
    bool isData = name.starts_with("DataSet") && name.find_first_not_of("0123456789", 7) == name.npos;
    if (isData && file.has(name + "/ResolutionLevel 0")) images.push_back({name, name, false, "", {}});
  }
  return images;
}

ArrayPyramid readImarisImage(const std::shared_ptr<const Hdf5File>& file, const std::string& key) {
  auto images = listImarisImages(*file);
  auto chosen = std::find_if(images.begin(), images.end(),
                             [&](const StoreImage& image) { return key.empty() || image.key == key; });
  if (chosen == images.end()) refuse(file->path(), fmt::format("the store holds no image {}", inQuotes(key)));
  ArrayPyramid pyramid = ImarisReader(file, chosen->key).read();
  if (pyramid.head.name.empty() && images.size() > 1) pyramid.head.name = chosen->name;
  return pyramid;
}

}  // namespace velum::io
