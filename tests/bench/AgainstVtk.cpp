#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

#include "Data.h"
#include "Sections.h"
#include "VtkScene.h"
#include "io/images/ImageFile.h"
#include "render/Renderer.h"

namespace velum::bench {

namespace {

constexpr glm::ivec2 kSize(800, 600);

/// The colours of two pictures, 0..255.
struct Difference {
  double rms = 0, mean = 0;
};

Difference compare(const Image& a, const Image& b) {
  Difference difference;
  std::size_t pixels = std::size_t(a.width) * std::size_t(a.height);
  for (std::size_t i = 0; i < pixels; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      double d = 255.0 * (double(a.pixels[i * a.channels.size() + c]) - double(b.pixels[i * b.channels.size() + c]));
      difference.rms += d * d;
      difference.mean += std::abs(d);
    }
  difference.rms = std::sqrt(difference.rms / double(3 * pixels));
  difference.mean /= double(3 * pixels);
  return difference;
}

Image sideBySide(const std::vector<Image>& images) {
  Image all{0, images.front().height, {"R", "G", "B"}, {}};
  for (const auto& image : images) all.width += image.width;
  all.pixels.resize(std::size_t(all.width) * std::size_t(all.height) * 3);
  auto* out = all.pixels.data();
  for (int y = 0; y < all.height; ++y)
    for (const auto& image : images)
      for (int x = 0; x < image.width; ++x)
        for (std::size_t c = 0; c < 3; ++c)
          *out++ =
              image.pixels[(std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * image.channels.size() + c];
  return all;
}

/// Times of frames, ms, by camera position.
struct Series {
  std::vector<double> wallMs, workMs;

  template <class Draw>
  void add(Draw draw) {
    double before = processorMs();
    auto start = std::chrono::steady_clock::now();
    draw();
    wallMs.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    workMs.push_back(processorMs() - before);
  }
  nlohmann::json figures() const {
    return {{"ms", median(wallMs)}, {"processorMs", median(workMs)}, {"allMs", wallMs}, {"allProcessorMs", workMs}};
  }
};

struct Times {
  Series gpu, cpu, ours, full;
  Difference toGpu, toCpu;
  std::string driver;  ///< GL_RENDERER of VTK's window.
};

/// One frame of ours, everything that depends on the camera included; data and programs are there already.
void renderOurs(render::Renderer& renderer, const scene::Scene& scene, const scene::Camera& camera) {
  Progress progress;
  render::Frame frame{scene, kSize};
  frame.scene.camera = camera;
  renderer.render(frame, progress);
}

/// All four in turn at every position, so that a load on the machine meets each of them alike.
Times measureCase(const Case& item, int positions, const std::string& pictures) {
  Times times;
  scene::Scene fair = plain(item.scene), full = item.scene;
  full.rayCast.samplesPerPixel = 1;
  VtkScene vtkGpu(fair, VtkScene::Mapper::Gpu, kSize), vtkCpu(fair, VtkScene::Mapper::Cpu, kSize);
  render::Renderer ours(sharedContext()), oursFull(sharedContext());
  scene::Camera warmUp = turned(item.scene.camera, -1, 17);
  vtkGpu.render(warmUp), vtkCpu.render(warmUp);
  renderOurs(ours, fair, warmUp), renderOurs(oursFull, full, warmUp);
  for (int i = 0; i < positions; ++i) {
    scene::Camera camera = turned(item.scene.camera, i, positions);
    times.gpu.add([&] { vtkGpu.render(camera); });
    times.cpu.add([&] { vtkCpu.render(camera); });
    times.ours.add([&] { renderOurs(ours, fair, camera); });
    times.full.add([&] { renderOurs(oursFull, full, camera); });
    if (i > 0) continue;
    Image gpu = vtkGpu.read(), cpu = vtkCpu.read();
    Image own = ours.read(), ownFull = oursFull.read();
    times.toGpu = compare(own, gpu);
    times.toCpu = compare(own, cpu);
    if (!pictures.empty())
      io::writeImage(sideBySide({gpu, cpu, own, ownFull}), std::filesystem::path(pictures) / (item.key + ".png"));
  }
  times.driver = vtkGpu.renderer();
  return times;
}

/// @param quantity  which times
std::vector<std::string> row(const std::string& title, const Times& t, std::vector<double> Series::*quantity) {
  double gpu = median(t.gpu.*quantity), cpu = median(t.cpu.*quantity), ours = median(t.ours.*quantity);
  return {title,
          formatMs(gpu),
          formatMs(cpu),
          formatMs(ours),
          fmt::format("{:.1f}", gpu / ours),
          fmt::format("{:.1f}", cpu / ours),
          formatMs(median(t.full.*quantity))};
}

}  // namespace

void measureAgainstVtk(const Options& options, Report& report) {
  int n = options.quick ? 128 : 256, positions = options.quick ? 2 : 5;
  report.section("vtk", "Against VTK's mappers");
  if (!hasDisplay()) {
    report.note("Left out: VTK needs an X display (`xvfb-run -a build/release/bin/velum-bench`).");
    return;
  }
  report.note(fmt::format(
      "{0} x {0} x {0} voxels, {1} x {2} pixels, half a voxel a step, shaded by a light at the eye, one sample a "
      "pixel; medians of {3} camera positions. Ratio: how many times faster ours is.",
      n, kSize.x, kSize.y, positions));
  std::vector<std::vector<std::string>> wall, work, pictures;
  std::string driver;
  for (const Case& item : makeCases(n, double(kSize.x) / kSize.y, true)) {
    Times t = measureCase(item, positions, options.pictures);
    driver = t.driver;
    wall.push_back(row(item.title, t, &Series::wallMs));
    work.push_back(row(item.title, t, &Series::workMs));
    pictures.push_back({item.title, fmt::format("{:.1f} / {:.1f}", t.toGpu.rms, t.toGpu.mean),
                        fmt::format("{:.1f} / {:.1f}", t.toCpu.rms, t.toCpu.mean)});
    report.figure(item.key, {{"vtkDriver", t.driver},
                             {"vtkGpu", t.gpu.figures()},
                             {"vtkCpu", t.cpu.figures()},
                             {"ours", t.ours.figures()},
                             {"oursEverythingOn", t.full.figures()},
                             {"timesFasterThanGpu", median(t.gpu.wallMs) / median(t.ours.wallMs)},
                             {"timesFasterThanCpu", median(t.cpu.wallMs) / median(t.ours.wallMs)},
                             {"timesLessWorkThanGpu", median(t.gpu.workMs) / median(t.ours.workMs)},
                             {"timesLessWorkThanCpu", median(t.cpu.workMs) / median(t.ours.workMs)},
                             {"toGpu", {{"rms", t.toGpu.rms}, {"mean", t.toGpu.mean}}},
                             {"toCpu", {{"rms", t.toCpu.rms}, {"mean", t.toCpu.mean}}}});
  }
  const std::vector<std::string> columns{"VTK GPU mapper", "VTK CPU mapper", "Velum",
                                         "ratio GPU",      "ratio CPU",      "Velum, shadows and occlusion on"};
  auto headed = [&](std::string first) {
    std::vector<std::string> all{std::move(first)};
    all.insert(all.end(), columns.begin(), columns.end());
    return all;
  };
  report.table(headed("frame, ms"), wall);
  report.note(
      "The same in processor time on all cores together, which other work on the machine does not lengthen much:");
  report.table(headed("processor time of a frame, ms"), work);
  report.table({"difference of the pictures, rms / mean of 255", "to VTK GPU", "to VTK CPU"}, pictures);
  report.note(fmt::format("VTK's windows drew with {}.", driver));
}

}  // namespace velum::bench
