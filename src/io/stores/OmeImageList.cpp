#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/stores/OmeGroup.h"
#include "io/stores/OmeImage.h"

namespace velum::io {

namespace {

constexpr std::size_t kMostImages = 20'000;  ///< a plate of 1536 wells has some fields each

/// Walks over the groups of a store.
class ImageList {
 public:
  explicit ImageList(const Store& store) : mStore(store) {}
  std::vector<StoreImage> images;

  void addRoot() {
    Json attributes = omeAttributes(mStore, "");
    if (memberOf(attributes, "plate").is_object()) {
      addPlate(memberOf(attributes, "plate"));
    } else if (memberOf(attributes, "well").is_object()) {
      addWell("", attributes, "");
    } else if (memberOf(attributes, "labels").is_array()) {
      addLabels("", memberOf(attributes, "labels"), "");
    } else if (memberOf(attributes, "bioformats2raw.layout").is_number()) {
      addSeries();
    } else {
      addImage("", "");
    }
  }

 private:
  void addImage(const std::string& key, const std::string& name) {
    auto image = readOmeImage(mStore, key);
    if (!image || images.size() >= kMostImages) return;
    std::string shown = !name.empty() ? name : !image->name.empty() ? image->name : key;
    images.push_back({key, shown, image->isLabels, "", {}});
    std::string labels = keyBelow(mStore, key, "labels");
    addLabels(labels, memberOf(omeAttributes(mStore, labels), "labels"), key);
  }

  /// Labels that are listed but not there, or damaged, do not take their image away.
  void addLabels(const std::string& key, const Json& names, const std::string& image) {
    if (!names.is_array()) return;
    for (const Json& name : names) {
      std::string word = wordOf(name);
      if (word.empty() || images.size() >= kMostImages) continue;
      images.push_back({keyBelow(mStore, key, word), word, true, image, {}});
    }
  }

  void addSeries() {
    Json ome = omeAttributes(mStore, "OME");
    if (const Json& series = memberOf(ome, "series"); series.is_array()) {
      for (const Json& name : series)
        if (std::string word = wordOf(name); !word.empty()) addImage(keyBelow(mStore, "", word), "");
      return;
    }
    for (std::size_t i = 0; i < kMostImages; ++i) {
      std::size_t before = images.size();
      addImage(std::to_string(i), "");
      if (images.size() == before) return;
    }
  }

  void addPlate(const Json& plate) {
    const Json& wells = memberOf(plate, "wells");
    if (!wells.is_array() || wells.empty()) refuse(omePath(mStore, ""), "its plate has no wells");
    for (const Json& well : wells) {
      std::string path = wordOf(memberOf(well, "path"));
      if (path.empty()) refuse(omePath(mStore, ""), "a well of its plate has no path");
      std::string key = keyBelow(mStore, "", path);
      addWell(key, omeAttributes(mStore, key), path);
    }
  }

  void addWell(const std::string& key, const Json& attributes, const std::string& name) {
    const Json& fields = memberOf(memberOf(attributes, "well"), "images");
    if (!fields.is_array()) return;  // a well that was never imaged
    for (const Json& field : fields) {
      std::string path = wordOf(memberOf(field, "path"));
      if (path.empty()) refuse(omePath(mStore, key), "an image of its well has no path");
      addImage(keyBelow(mStore, key, path), name.empty() ? "" : fmt::format("well {}, field {}", name, path));
    }
  }

  const Store& mStore;
};

}  // namespace

std::vector<StoreImage> listImages(const Store& store) {
  ImageList list(store);
  list.addRoot();
  return std::move(list.images);
}

}  // namespace velum::io
