#include <fmt/format.h>

#include "Data.h"
#include "Sections.h"
#include "render/Renderer.h"

namespace velum::bench {

namespace {

/// Median frame over a few positions, one sample a pixel, after a first frame that is not counted.
double frameMs(render::Frame frame, int positions) {
  Progress progress;
  render::Renderer renderer(sharedContext());
  scene::Camera start = frame.scene.camera;
  std::vector<double> times;
  for (int i = -1; i < positions; ++i) {
    frame.scene.camera = turned(start, i, positions + 2);
    renderer.render(frame, progress);
    if (i >= 0) times.push_back(renderer.stats().frameMs);
  }
  return median(times);
}

constexpr Opacity kOpacities[] = {Opacity::Opaque, Opacity::SkinOverBone, Opacity::Translucent};

/// One row a size, one column an opacity. `frameOf(row, opacity)` makes what is drawn.
template <class MakeFrame>
void table(Report& report, const std::string& key, const std::string& title, const std::vector<std::string>& names,
           int positions, MakeFrame frameOf) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t row = 0; row < names.size(); ++row) {
    rows.push_back({names[row]});
    for (Opacity opacity : kOpacities) {
      double ms = frameMs(frameOf(row, opacity), positions);
      rows.back().push_back(formatMs(ms));
      report.figure(fmt::format("{}/{}/{}", key, names[row], kOpacityNames[static_cast<int>(opacity)]), ms);
    }
  }
  report.table({title, std::string(kOpacityNames[0]), std::string(kOpacityNames[1]), std::string(kOpacityNames[2])},
               rows);
}

/// Cuts of every kind about the middle, none of which removes all.
std::vector<scene::Cut> makeCuts(int count) {
  std::vector<scene::Cut> cuts;
  for (int i = 0; i < count; ++i) {
    scene::Cut cut;
    cut.shape = static_cast<scene::CutShape>(i % 5);
    double angle = 2.4 * i;
    glm::dvec3 out(std::cos(angle), std::sin(angle), std::sin(1.7 * i));
    cut.axis = out;
    cut.centre = out * (i % 5 == 0 ? 85.0 : 95.0);
    cut.size = glm::dvec3(40.0);
    cuts.push_back(cut);
  }
  return cuts;
}

/// Bands of structures, one above the other.
LabelVolume makeBands(const Volume& volume, int count) {
  LabelVolume labels(volume.dims, volume.worldFromVoxel);
  glm::ivec3 size(volume.dims.x, volume.dims.y, 1);
  for (int z = 0; z < volume.dims.z; ++z) {
    std::vector<std::uint16_t> ids(std::size_t(size.x) * std::size_t(size.y),
                                   std::uint16_t(1 + z * count / volume.dims.z));
    labels.write({0, 0, z}, size, ids);
  }
  for (int id = 1; id <= count; ++id)
    labels.table.push_back({std::uint16_t(id), fmt::format("band {}", id), defaultLabelColor(std::uint16_t(id)), 1.0f});
  return labels;
}

}  // namespace

void measureScaling(const Options& options, Report& report) {
  int positions = options.quick ? 1 : 3;
  int n = options.quick ? 128 : 256;
  const glm::ivec2 size(800, 600);
  double aspect = 4.0 / 3.0;
  report.section("scaling", "How a frame scales");
  report.note(
      fmt::format("Milliseconds, one sample a pixel, half a voxel a step, no shadows, uint8; where a table does not "
                  "vary it: {}^3 voxels, "
                  "{} x {} pixels.",
                  n, size.x, size.y));
  std::vector<int> edges{64, 128, 256, 512};
  std::vector<glm::ivec2> sizes{{400, 300}, {800, 600}, {1600, 1200}};
  std::vector<int> cutCounts{0, 1, 4, 16, 100, 1000}, structureCounts{0, 1, 16, 100};
  if (options.quick) edges = {64, 128}, sizes.resize(2), cutCounts = {0, 4}, structureCounts = {0, 16};

  Shared<Volume> volume;
  std::vector<std::string> names;
  for (int edge : edges) names.push_back(fmt::format("{}^3", edge));
  table(report, "voxels", "voxels", names, positions, [&](std::size_t row, Opacity opacity) {
    if (!volume || volume->dims.x != edges[row]) volume = Shared<Volume>(makeShells(edges[row]));
    return render::Frame{plain(makeShellScene(volume, opacity, aspect)), size};
  });
  volume = Shared<Volume>(makeShells(n));
  names.clear();
  for (auto pixels : sizes) names.push_back(fmt::format("{} x {}", pixels.x, pixels.y));
  table(report, "pixels", "pixels", names, positions, [&](std::size_t row, Opacity opacity) {
    return render::Frame{plain(makeShellScene(volume, opacity, aspect)), sizes[row]};
  });
  names.clear();
  for (int count : cutCounts) names.push_back(std::to_string(count));
  table(report, "cuts", "cuts", names, positions, [&](std::size_t row, Opacity opacity) {
    render::Frame frame{plain(makeShellScene(volume, opacity, aspect)), size};
    frame.scene.cuts = makeCuts(cutCounts[row]);
    return frame;
  });
  names.clear();
  for (int count : structureCounts) names.push_back(std::to_string(count));
  Shared<LabelVolume> labels;
  int labelCount = 0;
  table(report, "structures", "structures", names, positions, [&](std::size_t row, Opacity opacity) {
    render::Frame frame{plain(makeShellScene(volume, opacity, aspect)), size};
    int count = structureCounts[row];
    if (count > 0 && labelCount != count) labels = Shared<LabelVolume>(makeBands(*volume, count)), labelCount = count;
    if (count > 0) {
      frame.scene.labels.data = labels;
      scene::completeStructures(frame.scene.labels);
    }
    return frame;
  });
}

}  // namespace velum::bench
