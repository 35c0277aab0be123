#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/Error.h"
#include "scene/SheetShape.h"

namespace velum {

/// The sheets of a golden case whose folds each driver lays elsewhere. By the paper's rule forces point away from the
/// middles of kernels, so that a particle above one goes to either side by the last bit of what was rounded on its way,
/// and takes its neighbours along. What is drawn are the sheets of case.sheets.json, in the order in which they settle;
/// those of this driver are compared with them as a whole.
class AcceptedSheets {
 public:
  explicit AcceptedSheets(const std::filesystem::path& folder) : mFile(folder / "case.sheets.json") {
    if (std::ifstream in(mFile); in) mAccepted = nlohmann::json::parse(in);
  }

  /// The accepted places of the next sheet, or its own where none are accepted yet.
  void take(scene::SheetShape& shape) {
    std::size_t next = mSettled.size();
    nlohmann::json rows = nlohmann::json::array();
    for (const glm::vec3& place : shape.places)
      for (int i = 0; i < 3; ++i) rows.push_back(rounded(place[i]));
    mSettled.push_back(rows);
    if (next >= mAccepted.size()) return;
    const nlohmann::json& accepted = mAccepted[next];
    if (accepted.size() != 3 * shape.places.size()) throw InputError(mFile.string() + ": other particles");
    double apart = 0;
    for (std::size_t i = 0; i < shape.places.size(); ++i) {
      glm::vec3 place(accepted[3 * i].get<float>(), accepted[3 * i + 1].get<float>(), accepted[3 * i + 2].get<float>());
      apart += glm::distance(place, shape.places[i]) / double(shape.places.size());
      shape.places[i] = place;
    }
    mApart = std::max(mApart, apart / meshOf(shape));
  }

  /// The largest mean distance of particles from where they were accepted, of all sheets; meshes of the sheet.
  double apart() const { return mApart; }
  bool areAccepted() const { return mSettled.size() == mAccepted.size(); }
  /// @return the file that holds the sheets that have settled now
  std::filesystem::path writeBeside() const {
    std::filesystem::path beside = mFile.parent_path() / "case.sheets.new.json";
    std::ofstream(beside) << mSettled.dump() << '\n';
    return beside;
  }
  const std::filesystem::path& file() const { return mFile; }

 private:
  /// Six digits: a thousandth of a mesh and less.
  static double rounded(float value) { return std::stod(fmt::format("{:.6g}", value)); }
  /// Along the edge, which lies on the frame.
  static double meshOf(const scene::SheetShape& shape) {
    return glm::distance(shape.places.front(), shape.places[std::size_t(shape.particles.x) - 1]) /
           (shape.particles.x - 1);
  }

  std::filesystem::path mFile;
  nlohmann::json mAccepted = nlohmann::json::array(), mSettled = nlohmann::json::array();
  double mApart = 0;
};

}  // namespace velum
