#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "Verbs.h"
#include "velum/core/Error.h"
#include "velum/io/ImageFile.h"
#include "velum/render/Renderer.h"
#include "velum/session/Open.h"

namespace velum::app {

namespace {

struct RenderOptions {
  Common common;
  InputOptions input;
  std::string output, size = "1280x720", saveScene;
  int samples = 0;
  bool layers = false, transparent = false, bruteForce = false;
};

/// Keeps some channels of a picture.
Image channelsOf(const Image& image, const std::vector<std::string>& names) {
  Image out{image.width, image.height, names, {}};
  std::vector<std::size_t> columns;
  for (const auto& name : names)
    for (std::size_t c = 0; c < image.channels.size(); ++c)
      if (image.channels[c] == name) columns.push_back(c);
  std::size_t count = std::size_t(image.width) * std::size_t(image.height);
  out.pixels.reserve(count * columns.size());
  for (std::size_t i = 0; i < count; ++i)
    for (auto c : columns) out.pixels.push_back(image.pixels[i * image.channels.size() + c]);
  return out;
}

/// Layers as PNGs beside the picture, each mapped into 0..1: normals and ids by the usual colour codes, depth from near to far.
void writeLayerPictures(const Image& image, const std::filesystem::path& output) {
  auto beside = [&](const char* what) {
    auto path = output;
    return path.replace_filename(fmt::format("{}.{}{}", output.stem().string(), what, output.extension().string()));
  };
  std::size_t count = std::size_t(image.width) * std::size_t(image.height);
  auto rgb = [&](Image source) {
    source.channels = {"R", "G", "B"};
    return source;
  };
  Image normal = rgb(channelsOf(image, {"normal.X", "normal.Y", "normal.Z"}));
  for (auto& v : normal.pixels) v = 0.5f + 0.5f * v;
  io::writeImage(normal, beside("normal"));
  Image alpha = channelsOf(image, {"A", "A", "A"}), depth = channelsOf(image, {"Z", "Z", "Z"}), id = channelsOf(image, {"id", "id", "id"});
  Image position = channelsOf(image, {"position.X", "position.Y", "position.Z"});
  io::writeImage(rgb(alpha), beside("alpha"));
  float nearest = 1e30f, farthest = 0.0f;
  for (auto z : depth.pixels)
    if (z < 1e30f) nearest = std::min(nearest, z), farthest = std::max(farthest, z);
  for (auto& z : depth.pixels) z = z < 1e30f ? 1.0f - 0.9f * (z - nearest) / std::max(1e-6f, farthest - nearest) : 0.0f;
  io::writeImage(rgb(depth), beside("depth"));
  for (std::size_t i = 0; i < count; ++i) {
    int value = int(id.pixels[i * 3]);
    glm::vec3 color = value ? defaultLabelColor(std::uint16_t(value)) : glm::vec3(0.0f);
    for (int c = 0; c < 3; ++c) id.pixels[i * 3 + std::size_t(c)] = color[c];
  }
  io::writeImage(rgb(id), beside("id"));
  float low[3] = {1e30f, 1e30f, 1e30f}, high[3] = {-1e30f, -1e30f, -1e30f};
  for (std::size_t i = 0; i < count * 3; ++i)
    if (depth.pixels[i] > 0) low[i % 3] = std::min(low[i % 3], position.pixels[i]), high[i % 3] = std::max(high[i % 3], position.pixels[i]);
  for (std::size_t i = 0; i < count * 3; ++i)
    position.pixels[i] = depth.pixels[i] > 0 ? (position.pixels[i] - low[i % 3]) / std::max(1e-6f, high[i % 3] - low[i % 3]) : 0.0f;
  io::writeImage(rgb(position), beside("position"));
}

int run(const RenderOptions& options) {
  glm::ivec2 size = parseSize(options.size);
  auto context = gpu::Context::create(options.common.context);
  render::Renderer renderer(*context);
  render::Frame frame;
  frame.scene = openScene(options.input, double(size.x) / size.y);
  frame.pictureSize = size;
  if (options.samples > 0) frame.scene.rayCast.samplesPerPixel = options.samples;
  if (options.transparent) frame.scene.background.transparent = true;
  if (options.bruteForce) frame.scene.rayCast.skipEmpty = frame.scene.rayCast.stopOpaque = false;

  bool isExr = std::filesystem::path(options.output).extension() == ".exr";
  render::Layers layers;
  if (options.layers) layers = {true, true, true, true};
  int window = std::min(4096, context->limits().texture2d);
  auto start = std::chrono::steady_clock::now();
  Image image = render::renderPicture(renderer, frame, layers, window, consoleProgress());
  double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  consoleProgress().report(1.0, "");

  std::string text = session::sceneTextFor(frame.scene, options.output == "-" ? "." : options.output);
  if (options.layers && !isExr && options.output != "-") writeLayerPictures(image, options.output);
  std::vector<std::string> color{"R", "G", "B"};
  if (frame.scene.background.transparent) color.push_back("A");
  io::writeImage(options.layers && isExr ? image : channelsOf(image, color), options.output, text);
  if (!options.saveScene.empty()) session::saveScene(frame.scene, options.saveScene);

  const render::Stats& stats = renderer.stats();
  if (!stats.reduction.empty()) fmt::print(stderr, "note: {}\n", stats.reduction);
  if (options.common.json) {
    Json json = {{"renderer", stats.renderer}, {"size", {size.x, size.y}}, {"frameMs", stats.frameMs}, {"uploadMs", stats.uploadMs}, {"totalMs", ms},
                 {"samples", stats.samples}, {"longestStepMs", stats.longestStepMs}, {"passes", stats.passesMs}, {"reduction", stats.reduction}, {"output", options.output}};
    if (options.output != "-") printJson(json);
    else fmt::print(stderr, "{}\n", json.dump());
  }
  return 0;
}

}  // namespace

Run registerRender(CLI::App& verb) {
  auto options = std::make_shared<RenderOptions>();
  addCommon(verb, options->common);
  addInput(verb, options->input, true);
  verb.add_option("-o,--output", options->output, "picture to write: .png, .tif, .exr; - writes PNG to stdout")->required();
  verb.add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
  verb.add_option("--samples", options->samples, "pictures that are averaged, 1 to 256; default: as the scene says")->check(CLI::Range(1, 256));
  verb.add_flag("--layers", options->layers, "also alpha, normal, depth, structure id, position: in the EXR, or as PNGs beside");
  verb.add_flag("--transparent", options->transparent, "no background, with alpha");
  verb.add_flag("--brute-force", options->bruteForce, "without skipping and early ends: the reference for every acceleration");
  verb.add_option("--save-scene", options->saveScene, "write the scene as JSON, too");
  return [options] { return run(*options); };
}

}  // namespace velum::app
