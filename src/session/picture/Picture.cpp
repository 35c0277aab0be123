#include "session/picture/Picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>

#include "core/FileName.h"
#include "core/ImageChannels.h"
#include "core/Memory.h"
#include "core/ReplaceFile.h"
#include "core/Text.h"
#include "io/images/ImageFile.h"
#include "io/kinds/FileKind.h"
#include "render/RenderPicture.h"
#include "render/section/SectionImage.h"
#include "scene/Shown.h"
#include "session/document/Open.h"
#include "session/lettering/Lettering.h"
#include "session/model/TrueLevels.h"
#include "session/picture/Cryptomatte.h"
#include "session/picture/LayerPictures.h"

namespace velum::session {

namespace {

constexpr double kMmPerInch = 25.4;

/// What is drawn of a scene with inlays for each of kInlayLayers.
constexpr render::InlayParts kInlayParts[] = {{true, false, false}, {false, true, false}, {false, false, true}};

/// Maxima cannot be put together from layers.
bool hasInlayLayers(const scene::Scene& scene) {
  return scene.rayCast.mode != scene::RenderMode::Mip &&
         std::ranges::any_of(scene::enabledOf(scene.cuts), scene::isInlay);
}

/// The image with the channels of another one of its size behind its own.
Image withChannels(const Image& image, const Image& more, const std::vector<std::string>& names) {
  Image out{image.width, image.height, image.channels, {}};
  out.channels.insert(out.channels.end(), names.begin(), names.end());
  std::size_t count = std::size_t(image.width) * std::size_t(image.height), n = image.channels.size(),
              k = more.channels.size();
  out.pixels.reserve(image.pixels.size() + more.pixels.size());
  for (std::size_t i = 0; i < count; ++i) {
    out.pixels.insert(out.pixels.end(), &image.pixels[i * n], &image.pixels[i * n] + n);
    out.pixels.insert(out.pixels.end(), &more.pixels[i * k], &more.pixels[i * k] + k);
  }
  return out;
}

}  // namespace

glm::ivec2 parsePictureSize(const std::string& text, double dpi) {
  std::string_view unit = text;
  auto number = [&] { return takeNumber(unit).value_or(std::nan("")); };
  double width = number();
  bool ok = unit.starts_with('x');
  if (ok) unit.remove_prefix(1);
  double height = number();
  double inches = unit == "cm" ? 1 / 2.54 : unit == "mm" ? 1 / 25.4 : unit == "in" ? 1.0 : 0.0;
  bool isPixels = unit.empty() || unit == "px";
  ok = ok && (isPixels || inches > 0) && std::isfinite(width) && std::isfinite(height);
  double scale = isPixels ? 1.0 : inches * (dpi > 0 ? dpi : 300.0);
  glm::dvec2 pixels = glm::round(glm::dvec2(width, height) * scale);
  if (!ok || !(pixels.x >= 1 && pixels.y >= 1 && pixels.x <= 65536 && pixels.y <= 65536) ||
      (isPixels && (pixels.x != width || pixels.y != height)))
    throw ArgumentError(fmt::format(
        "size {}: expected WIDTHxHEIGHT in pixels, 1 to 65536, or with a unit: 1280x720, 12x8cm, 120x80mm, 5x3in",
        text));
  return glm::ivec2(pixels);
}

namespace {

/// As a shell takes it back unchanged.
std::string quoted(const std::string& text) {
  bool isPlain = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) || std::string_view("/._-+,=:@%").find(char(c)) != std::string_view::npos;
  });
  if (isPlain) return text;
  std::string out = "'";
  for (char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace

std::string pictureCommand(const std::filesystem::path& scene, const PictureOptions& options,
                           const std::filesystem::path& output, std::string_view verb) {
  std::string command = fmt::format("velum-batch {} {} -o {} --size {}x{}", verb, quoted(scene.string()),
                                    quoted(output.string()), options.size.x, options.size.y);
  if (options.samples > 0) command += fmt::format(" --samples {}", options.samples);
  if (options.dpi > 0) command += fmt::format(" --dpi {:g}", options.dpi);
  if (options.bits != PictureOptions().bits) command += fmt::format(" --bits {}", options.bits);
  if (options.transparent) command += " --transparent";
  if (options.layers) command += " --layers";
  return command;
}

scene::Scene sceneForPicture(const scene::Scene& scene, const PictureOptions& options) {
  scene::Scene out = scene;
  if (options.samples > 0) out.rayCast.samplesPerPixel = options.samples;
  if (options.transparent) out.background.transparent = true;
  // A picture of a resolution is as wide on the page as its pixels say.
  if (options.dpi > 0.0 && out.lettering.pageWidth > 0.0)
    out.lettering.pageWidth = options.size.x / options.dpi * kMmPerInch;
  return out;
}

namespace {

render::Layers layersOf(const PictureOptions& options, const scene::Scene& scene) {
  render::Layers layers;
  if (options.layers) layers = {true, true, true, true, true, bool(scene.model.data)};
  layers.isFine = options.bits > 8;
  return layers;
}

scene::Scene drawnScene(const scene::Scene& scene, const PictureOptions& options, Progress& progress) {
  scene::Scene drawn = sceneForPicture(scene, options);
  TrueLevels().give(drawn.model, progress);
  return drawn;
}

/// @param drawn  as drawnScene() gives it
Image pixelsOf(render::Renderer& renderer, const scene::Scene& drawn, const PictureOptions& options,
               const gpu::Limits& limits, Progress& progress) {
  render::Frame frame;
  frame.scene = drawn;
  frame.pictureSize = options.size;
  frame.brickBytes = memoryBudget().gpuBrickBytes;
  int first = options.part.firstOf(options.size.y), end = options.part.endOf(options.size.y);
  if (options.part.parts > 1) {
    frame.windowOrigin = {0, first};
    frame.windowSize = {options.size.x, end - first};
  }
  render::Layers layers = layersOf(options, drawn);
  int window = std::min(4096, limits.texture2d);
  Image image = render::renderPicture(renderer, frame, withLetteringLayers(layers, drawn), window, progress);
  if (!options.layers || !hasInlayLayers(frame.scene)) return image;
  // As they were drawn: what is put together elsewhere is finished there.
  frame.scene.background.transparent = true;
  frame.scene.finish = {};
  for (std::size_t i = 0; i < std::size(kInlayLayers); ++i) {
    frame.parts = kInlayParts[i];
    image = withChannels(image, render::renderPicture(renderer, frame, {.isFine = layers.isFine}, window, progress),
                         colorChannels(kInlayLayers[i]));
  }
  return image;
}

Image lettered(Image image, const scene::Scene& drawn, const PictureOptions& options, Progress& progress,
               const Seen* known) {
  layOver(letteringBlocks(drawn, options.size, seenIn(image, drawn, progress, known)), image);
  render::Layers layers = layersOf(options, drawn);
  std::vector<std::string> channels = image.channels;
  for (auto [isAsked, name] :
       {std::pair(layers.type, "type"), {layers.structure, "id"}, {layers.instance, "instance"}, {layers.depth, "Z"}})
    if (!isAsked) std::erase(channels, name);
  return channels == image.channels ? image : channelsOf(image, channels);
}

}  // namespace

Image drawPixels(render::Renderer& renderer, const scene::Scene& scene, const PictureOptions& options,
                 const gpu::Limits& limits, Progress& progress) {
  return pixelsOf(renderer, drawnScene(scene, options, progress), options, limits, progress);
}

Image withLettering(Image pixels, const scene::Scene& scene, const PictureOptions& options, Progress& progress) {
  return lettered(std::move(pixels), drawnScene(scene, options, progress), options, progress, nullptr);
}

Image drawPicture(render::Renderer& renderer, const scene::Scene& scene, const PictureOptions& options,
                  const gpu::Limits& limits, Progress& progress, const Seen* known) {
  scene::Scene drawn = drawnScene(scene, options, progress);
  return lettered(pixelsOf(renderer, drawn, options, limits, progress), drawn, options, progress, known);
}

Image imageOf(const render::SectionImage& section) {
  Image image{section.size.x, section.size.y, {"R", "G", "B", "A"}, {}};
  image.pixels.reserve(section.pixels.size() * 4);
  for (std::uint32_t pixel : section.pixels)
    for (int shift : {16, 8, 0, 24}) image.pixels.push_back(float(pixel >> shift & 255u) / 255.0f);
  return image;
}

Image drawSectionPicture(const scene::Scene& scene, scene::SectionKind kind, const PictureOptions& options,
                         Progress& progress, const Seen* known) {
  const scene::Scene drawn = sceneForPicture(scene, options);
  scene::SectionPlane plane = scene::makeSectionPlane(drawn, kind, glm::dvec2(options.size));
  render::SectionImage section = render::drawSection(drawn, plane);
  Image image = imageOf(section);
  layOver(letteringBlocks(drawn, kind, options.size, seenInSection(section, plane, drawn, progress, known)), image);
  return image;
}

void expectPictureFormat(const std::filesystem::path& path) {
  if (io::isDrawing(path)) return;
  try {
    io::expectImageFormat(path);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}; with lines and letters as .svg or .pdf", error.what()));
  }
}

void expectPictureFile(const std::filesystem::path& path) {
  expectPictureFormat(path);
  expectReplaceable(path);
}

std::vector<std::filesystem::path> savePicture(const Image& image, const scene::Scene& scene,
                                               const PictureOptions& options, const std::filesystem::path& path) {
  scene::Scene drawn = sceneForPicture(scene, options);
  std::string text = sceneTextFor(drawn, path == "-" ? "." : path);
  bool isExr = lowerExtension(path) == ".exr";
  std::vector<std::filesystem::path> files{path};
  if (options.layers && !isExr && path != "-")
    for (auto& layer : writeLayerPictures(image, scene::typeColors(scene.model), options.dpi, path))
      files.push_back(std::move(layer));
  std::vector<std::string> color{"R", "G", "B"};
  if (drawn.background.transparent) color.push_back("A");
  if (!options.layers || !isExr) {
    io::writeImage(channelsOf(image, color), path, text, options.dpi, {}, options.bits);
    return files;
  }
  std::vector<io::ImageAttribute> attributes;
  bool hasTypes = scene.model.data && channelIndex(image, "type") >= 0;
  io::writeImage(hasTypes ? withMattes(image, scene, attributes) : image, path, text, options.dpi, attributes);
  return files;
}

}  // namespace velum::session
