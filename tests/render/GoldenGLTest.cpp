// Pictures that people have looked at. One folder a case: case.json says what to draw, case.png is the picture.
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "AcceptedSheets.h"
#include "GlFixture.h"
#include "SourceFolder.h"
#include "io/images/ImageCompare.h"
#include "io/images/ImageFile.h"
#include "io/phantoms/Sample.h"
#include "io/phantoms/Virion.h"
#include "model/Levels.h"
#include "render/RenderPicture.h"
#include "scene/Presets.h"
#include "scene/json/Paths.h"
#include "session/film/Film.h"
#include "session/film/ReadyFilms.h"
#include "session/membrane/Membranes.h"

namespace velum {
namespace {

namespace fs = std::filesystem;

class GoldenGL : public GlTest, public testing::WithParamInterface<std::string> {};

scene::StandardView viewNamed(const std::string& name) {
  for (int i = 0; i < 7; ++i)
    if (enumName(scene::StandardView(i)) == name) return scene::StandardView(i);
  throw ArgumentError("no view " + name);
}

using Json = nlohmann::json;

/// The virion, which is a model.
scene::Scene modelOf(const Json& what) {
  Progress progress;
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(io::makeVirion(progress));
  scene.model.levels = Shared<LevelSet>(model::computeLevels(*scene.model.data, progress));
  scene::applyPreset(scene, what.at("preset").get<std::string>());
  return scene;
}

scene::Scene dataOf(const Json& what) {
  if (what.at("sample") == "virion") return modelOf(what);
  Progress progress;
  io::Sample sample = io::makeSample(what.at("sample").get<std::string>(), what.at("voxels"), progress);
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(std::move(sample.volume));
  scene::applyPreset(scene, what.at("preset").get<std::string>());
  if (what.value("labels", false)) {
    scene.labels.data = Shared<LabelVolume>(std::move(sample.labels));
    scene::completeStructures(scene.labels);
  }
  return scene;
}

/// Shapes of cuts come first: only a membrane has a membrane's fields.
void setFields(scene::Scene& scene, const Json& fields) {
  for (bool wantsShapes : {true, false})
    for (const auto& [path, value] : fields.items())
      if (path.ends_with(".shape") == wantsShapes)
        scene::setField(scene, path, value.is_string() ? value.get<std::string>() : value.dump());
}

/// What a sheet at rest depends on in the cases, which have one membrane: nothing else is changed between panels.
scene::Cut restOf(scene::Cut cut) {
  const scene::Membrane plain;
  cut.face = scene::Cut().face;
  cut.membrane->use = plain.use;
  cut.membrane->look = plain.look;
  cut.membrane->inlayOpacity = plain.inlayOpacity;
  cut.membrane->emphasis = plain.emphasis;
  cut.membrane->falloff = plain.falloff;
  return cut;
}

/// Draws the panels of a case. A passive sheet settles once for panels that differ in how it is shown; an active one
/// goes on from panel to panel.
class Panels {
 public:
  Panels(const Json& what, gpu::Context& context, AcceptedSheets& sheets)
      : mWhat(what), mRenderer(context), mData(dataOf(what)), mSheets(sheets) {}

  Image draw(const Json& panel) {
    scene::Scene scene = sceneOf(panel);
    settle(scene);
    return picture(std::move(scene));
  }

  std::vector<Image> drawFilm(const Json& asked) {
    scene::Scene scene = sceneOf(Json::object());
    auto kind = enumValue<session::ReadyFilm>(asked.at("ready").get<std::string>());
    session::Film film(session::withReadyFilm(scene, kind.value(), asked.at("frames")));
    std::vector<Image> frames;
    for (int i = 0; i < film.count(); ++i) frames.push_back(picture(film.at(i, 0.0, mProgress).drawn));
    return frames;
  }

 private:
  glm::ivec2 size() const { return {mWhat.at("size")[0], mWhat.at("size")[1]}; }

  scene::Scene sceneOf(const Json& panel) const {
    scene::Scene scene = mData;
    std::string view = panel.contains("view") ? panel.at("view") : mWhat.at("view");
    scene.camera = scene::frameCamera(scene, viewNamed(view), double(size().x) / size().y);
    setFields(scene, mWhat.at("set"));
    if (panel.contains("set")) setFields(scene, panel.at("set"));
    return scene;
  }

  Image picture(scene::Scene scene) {
    render::Frame frame;
    frame.pictureSize = size();
    frame.scene = std::move(scene);
    return render::renderPicture(mRenderer, frame, {}, 4096, mProgress);
  }

  void settle(scene::Scene& scene) {
    if (!session::hasMembranes(scene)) return;
    scene::Cut& cut = scene.cuts[0];
    if (scene::Cut rest = restOf(cut); mRest != rest) {
      bool isActive = cut.membrane->repositioning == scene::Repositioning::Active;
      if (isActive) cut.membrane->shape = mShape;
      session::settleMembranes(scene, {}, mProgress);
      mRest = rest;
      mShape = cut.membrane->shape;
      if (cut.membrane->field.rule == scene::KernelRule::Paper) mSheets.take(mShape);
    }
    cut.membrane->shape = mShape;
  }

  const Json& mWhat;
  render::Renderer mRenderer;
  scene::Scene mData;
  AcceptedSheets& mSheets;
  std::optional<scene::Cut> mRest;
  scene::SheetShape mShape;
  Progress mProgress;
};

/// Pictures side by side, without alpha, which is 1 before a background. All are of one size.
Image joinRow(const std::vector<Image>& panels) {
  Image row{panels[0].width * int(panels.size()), panels[0].height, {"R", "G", "B"}, {}};
  for (int y = 0; y < row.height; ++y)
    for (const auto& panel : panels)
      for (int x = 0; x < panel.width; ++x) {
        const float* pixel = &panel.pixels[(std::size_t(y) * std::size_t(panel.width) + std::size_t(x)) * 4];
        row.pixels.insert(row.pixels.end(), pixel, pixel + 3);
      }
  return row;
}

/// Keys: sample, voxels, labels (true: shown), preset, view, size [w, h], set {path: value}, panels [{view, set}] (what
/// differs in each of several pictures in a row) or film {ready: a ready-made film, frames}, maxFraction (of the pixels
/// that may differ by more, see Allowance) and why.
Image draw(const Json& what, gpu::Context& context, AcceptedSheets& sheets) {
  Panels panels(what, context, sheets);
  if (what.contains("film")) return joinRow(panels.drawFilm(what.at("film")));
  std::vector<Image> images;
  for (const auto& panel : what.value("panels", Json::array({Json::object()}))) images.push_back(panels.draw(panel));
  return joinRow(images);
}

bool isGpu(const gpu::Context& context) { return context.limits().renderer.find("llvmpipe") == std::string::npos; }

/// How far each pixel may be from the accepted one, 0..255, and the share of those that may be farther.
struct Allowance {
  double difference = 2, fraction = 0;
};

/// Software drivers draw each pixel as it was accepted, but for those whose ray grazes the edge of something: those are
/// the case's `maxFraction`. GPUs take places between voxels in 256 steps, which shows in translucent material (of the
/// seismic volume 0.45 % by more than 5).
Allowance allowanceOf(const Json& what, const gpu::Context& context) {
  return isGpu(context) ? Allowance{5, 0.005} : Allowance{2, what.value("maxFraction", 0.0)};
}

/// Of meshes, in the mean over all particles.
constexpr double kMostSheetApart = 0.05;

TEST_P(GoldenGL, LooksAsAccepted) {
  fs::path folder = sourceFolder() / "tests" / "golden" / GetParam();
  std::ifstream in(folder / "case.json");
  ASSERT_TRUE(in) << folder / "case.json"
                  << " is missing";
  Json what = Json::parse(in);
  AcceptedSheets sheets(folder);
  Image rgb = draw(what, context(), sheets);
  if (!sheets.areAccepted()) {
    fs::path beside = sheets.writeBeside();
    FAIL() << "there are no accepted sheets yet; these are " << beside << ": accept them with\n  mv " << beside.string()
           << " " << sheets.file().string();
  }
  RecordProperty("sheetApart", fmt::format("{:.5f}", sheets.apart()));
  if (!isGpu(context())) {
    EXPECT_LE(sheets.apart(), kMostSheetApart) << "meshes, from where particles were accepted";
  }

  fs::path accepted = folder / "case.png", beside = folder / "case.new.png";
  std::string how = "look at it, then accept it with\n  mv " + beside.string() + " " + accepted.string();
  if (!fs::exists(accepted)) {
    io::writeImage(rgb, beside);
    FAIL() << "there is no accepted picture yet; the new one is " << beside << ": " << how;
  }
  Allowance allowance = allowanceOf(what, context());
  Image known = io::readImage(accepted);
  io::ImageDifference difference = io::compareImages(known, rgb, allowance.difference);
  RecordProperty("largest", std::lround(difference.maxDifference));
  RecordProperty("millionthsOver", std::lround(difference.failingFraction * 1e6));
  if (difference.failingFraction <= allowance.fraction) return;
  io::writeImage(rgb, beside);
  io::writeImage(io::differenceImage(known, rgb, allowance.difference), folder / "case.diff.png");
  FAIL() << difference.failingFraction * 100 << " % of the pixels differ by more than " << allowance.difference
         << " (the largest by " << difference.maxDifference << "); the new picture is " << beside
         << ": if it is right, " << how;
}

std::vector<std::string> goldenCases() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(sourceFolder() / "tests" / "golden"))
    if (fs::exists(entry.path() / "case.json")) names.push_back(entry.path().filename().string());
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
