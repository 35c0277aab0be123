#include <fmt/format.h>

#include <chrono>

#include "Data.h"
#include "FetchCount.h"
#include "Sections.h"
#include "gpu/Program.h"
#include "gpu/Texture.h"
#include "render/Renderer.h"

namespace velum::bench {

namespace {

constexpr glm::ivec2 kSize(800, 600);
constexpr int kFetchesPerRay = 128;

struct TexelKind {
  const char* name;
  gpu::Format format;
};
constexpr TexelKind kTexels[] = {{"R8", gpu::Format::R8}, {"R16", gpu::Format::R16}, {"R32F", gpu::Format::R32f}};

/// Millions of trilinear fetches a second from a texture of n^3, best of a few.
double fetchRate(gpu::Format format, int n, int turns) {
  sharedContext();
  gpu::Program program({"bench/trilinear.comp"});
  auto volume = gpu::Texture::make3d("fetches", format, glm::ivec3(n));
  std::vector<std::byte> texels(std::size_t(n) * std::size_t(n) * std::size_t(n) * gpu::texelBytes(format),
                                std::byte(0x3e));
  volume.write(glm::ivec3(0), glm::ivec3(n), texels.data());
  auto sums = gpu::Texture::make2d("sums", gpu::Format::R32f, kSize);
  double best = 0;
  for (int turn = 0; turn <= turns; ++turn) {
    volume.bindSampler(0);
    sums.bindImage(0, gpu::Access::Write);
    program.set(0, glm::ivec4(kSize, kFetchesPerRay, 0));
    auto start = std::chrono::steady_clock::now();
    gpu::dispatch(program, {(kSize.x + 7) / 8, (kSize.y + 7) / 8, 1});
    gpu::finish();
    double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (turn > 0) best = std::max(best, double(kSize.x) * kSize.y * kFetchesPerRay * 1e-6 / seconds);
  }
  return best;
}

std::string_view texelOf(SampleType type) {
  if (type == SampleType::UInt8) return "R8";
  return sampleSize(type) == 2 ? "R16" : "R32F";
}

}  // namespace

void measureFetches(const Options& options, Report& report) {
  int n = options.quick ? 128 : 256;
  report.section("fetches", "Fetches: the driver's rate and ours");
  std::vector<std::vector<std::string>> rows;
  std::map<std::string_view, double> rates;
  for (const auto& kind : kTexels) {
    rates[kind.name] = fetchRate(kind.format, n, options.quick ? 2 : 5);
    rows.push_back({kind.name, fmt::format("{:.0f}", rates[kind.name])});
    report.figure(fmt::format("rate/{}", kind.name), rates[kind.name]);
  }
  report.note(
      fmt::format("A loop of {} trilinear fetches a ray from {}^3 texels and nothing else.", kFetchesPerRay, n));
  report.table({"texel", "million fetches a second"}, rows);
  rows.clear();
  for (const Case& item : makeCases(n, double(kSize.x) / kSize.y, false)) {
    scene::Scene scene = plain(item.scene);
    scene.camera = turned(scene.camera, 0, 5);
    FetchCount count = countFetches(scene, kSize);
    Progress progress;
    render::Renderer renderer(sharedContext());
    std::vector<double> times;
    // A frame that equals the last one is not drawn again, so the background tells them apart.
    for (int turn = 0; turn < 4; ++turn) {
      scene.background.top.r = float(turn) / 255.0f;
      renderer.render({scene, kSize}, progress);
      if (turn > 0) times.push_back(renderer.stats().frameMs);
    }
    double ms = median(times), total = count.samples + count.gradients, rate = total / ms * 1e3;
    double driver = rates[texelOf(scene.volume.data->type)];
    rows.push_back({item.title, fmt::format("{:.1f}", count.samples), fmt::format("{:.1f}", count.gradients),
                    formatMs(ms), fmt::format("{:.0f}", rate), fmt::format("{:.0f} %", 100.0 * rate / driver)});
    report.figure(item.key, {{"millionSamples", count.samples},
                             {"millionGradientFetches", count.gradients},
                             {"frameMs", ms},
                             {"millionPerSecond", rate},
                             {"shareOfDriver", rate / driver}});
  }
  report.note(
      "What the same rays need at the least (values at half-voxel steps in cells that are not empty, six more for the "
      "gradient of "
      "each sample that shows), counted on the processor, over the time of our frame. More than 100 % means that the "
      "ray "
      "caster gets by with fewer fetches than that.");
  report.table({"scene", "values, millions", "gradients, millions", "frame, ms", "million fetches a second",
                "of the driver's rate"},
               rows);
}

}  // namespace velum::bench
