// Pictures that people have looked at. One folder a case: case.json says what to draw, case.png is the picture.
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "GlFixture.h"
#include "velum/io/ImageFile.h"
#include "velum/io/Sample.h"
#include "velum/render/Renderer.h"
#include "velum/scene/Json.h"
#include "velum/scene/Presets.h"

namespace velum {
namespace {

namespace fs = std::filesystem;

class GoldenGL : public GlTest, public testing::WithParamInterface<std::string> {};

scene::StandardView viewNamed(const std::string& name) {
  for (int i = 0; i < 7; ++i)
    if (enumName(scene::StandardView(i)) == name) return scene::StandardView(i);
  throw ArgumentError("no view " + name);
}

/// Keys: sample, voxels, labels (true: shown), preset, view, size [w, h], set {path: value}, maxDifference,
/// maxFraction.
render::Frame frameOf(const nlohmann::json& what) {
  Progress progress;
  io::Sample sample = io::makeSample(what.at("sample").get<std::string>(), what.at("voxels"), progress);
  render::Frame frame;
  frame.pictureSize = {what.at("size")[0], what.at("size")[1]};
  scene::Scene& scene = frame.scene;
  scene.volume.data = Shared<Volume>(std::move(sample.volume));
  scene::applyPreset(scene, what.at("preset").get<std::string>());
  if (what.value("labels", false)) {
    scene.labels.data = Shared<LabelVolume>(std::move(sample.labels));
    scene::completeStructures(scene.labels);
  }
  scene.camera =
      scene::frameCamera(scene, viewNamed(what.at("view")), double(frame.pictureSize.x) / frame.pictureSize.y);
  for (const auto& [path, value] : what.at("set").items())
    scene::setField(scene, path, value.is_string() ? value.get<std::string>() : value.dump());
  return frame;
}

TEST_P(GoldenGL, LooksAsAccepted) {
  fs::path folder = fs::path(VELUM_SOURCE_DIR) / "tests" / "golden" / GetParam();
  std::ifstream in(folder / "case.json");
  ASSERT_TRUE(in) << folder / "case.json"
                  << " is missing";
  nlohmann::json what = nlohmann::json::parse(in);
  render::Renderer renderer(context());
  Progress progress;
  render::Frame frame = frameOf(what);
  Image image = render::renderPicture(renderer, frame, {}, 4096, progress);
  // PNG without alpha: drop the fourth channel, which is 1 before a background.
  Image rgb{image.width, image.height, {"R", "G", "B"}, {}};
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    if (i % 4 != 3) rgb.pixels.push_back(image.pixels[i]);

  fs::path accepted = folder / "case.png", beside = folder / "case.new.png";
  std::string how = "look at it, then accept it with\n  mv " + beside.string() + " " + accepted.string();
  if (!fs::exists(accepted)) {
    io::writeImage(rgb, beside);
    FAIL() << "there is no accepted picture yet; the new one is " << beside << ": " << how;
  }
  double threshold = what.value("maxDifference", 5.0), fraction = what.value("maxFraction", 0.001);
  Image known = io::readImage(accepted);
  io::ImageDifference difference = io::compareImages(known, rgb, threshold);
  if (difference.failingFraction <= fraction) return;
  io::writeImage(rgb, beside);
  io::writeImage(io::differenceImage(known, rgb, threshold), folder / "case.diff.png");
  FAIL() << difference.failingFraction * 100 << " % of the pixels differ by more than " << threshold
         << " (the largest by " << difference.maxDifference << "); the new picture is " << beside
         << ": if it is right, " << how;
}

std::vector<std::string> goldenCases() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(fs::path(VELUM_SOURCE_DIR) / "tests" / "golden"))
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}
INSTANTIATE_TEST_SUITE_P(Cases, GoldenGL, testing::ValuesIn(goldenCases()), [](const auto& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace velum
