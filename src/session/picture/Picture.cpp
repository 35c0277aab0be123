#include "velum/session/picture/Picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "velum/core/Text.h"
#include "velum/gpu/Context.h"
#include "velum/io/images/ImageFile.h"
#include "velum/render/RenderPicture.h"
#include "velum/render/section/SectionImage.h"
#include "velum/session/document/Open.h"
#include "velum/session/membrane/Membranes.h"
#include "velum/session/picture/Cryptomatte.h"

namespace velum::session {

namespace {

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

/// Layers of a scene with inlays, from front to back: each of them alone.
struct InlayLayer {
  const char* name;
  render::InlayParts parts;
};
constexpr InlayLayer kInlayLayers[] = {
    {"front", {true, false, false}}, {"inlay", {false, true, false}}, {"behind", {false, false, true}}};

/// Maxima cannot be put together from layers.
bool hasInlayLayers(const scene::Scene& scene) {
  return scene.rayCast.mode != scene::RenderMode::Mip &&
         std::any_of(scene.cuts.begin(), scene.cuts.end(),
                     [](const scene::Cut& cut) { return cut.enabled && scene::isInlay(cut); });
}

std::vector<std::string> colorNames(const std::string& layer) {
  return {layer + ".R", layer + ".G", layer + ".B", layer + ".A"};
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

/// Layers as PNGs beside the picture, each mapped into 0..1: normals and ids by the usual colour codes, depth from near
/// to far.
///
/// @param typeColors  of the types of a model; empty: there is none
void writeLayerPictures(const Image& image, const std::vector<glm::vec3>& typeColors,
                        const std::filesystem::path& output) {
  auto beside = [&](const char* what) {
    auto path = output;
    return path.replace_filename(fmt::format("{}.{}{}", output.stem().string(), what, output.extension().string()));
  };
  // Parts of an inlay, where the picture has them.
  for (const InlayLayer& layer : kInlayLayers) {
    Image color = channelsOf(image, colorNames(layer.name));
    if (color.channels.size() * std::size_t(image.width) * std::size_t(image.height) != color.pixels.size()) continue;
    color.channels = {"R", "G", "B", "A"};
    io::writeImage(color, beside(layer.name));
  }
  std::size_t count = std::size_t(image.width) * std::size_t(image.height);
  auto rgb = [&](Image source) {
    source.channels = {"R", "G", "B"};
    return source;
  };
  // Normals: -1..1 becomes 0..1.
  Image normal = rgb(channelsOf(image, {"normal.X", "normal.Y", "normal.Z"}));
  for (auto& v : normal.pixels) v = 0.5f + 0.5f * v;
  io::writeImage(normal, beside("normal"));
  Image alpha = channelsOf(image, {"A", "A", "A"}), depth = channelsOf(image, {"Z", "Z", "Z"}),
        id = channelsOf(image, {"id", "id", "id"});
  Image position = channelsOf(image, {"position.X", "position.Y", "position.Z"});
  io::writeImage(rgb(alpha), beside("alpha"));
  // Depth: near is light, what is hit nowhere is black.
  float nearest = 1e30f, farthest = 0.0f;
  for (auto z : depth.pixels)
    if (z < 1e30f) nearest = std::min(nearest, z), farthest = std::max(farthest, z);
  for (auto& z : depth.pixels) z = z < 1e30f ? 1.0f - 0.9f * (z - nearest) / std::max(1e-6f, farthest - nearest) : 0.0f;
  io::writeImage(rgb(depth), beside("depth"));
  // Ids in the colours that structures have by themselves.
  for (std::size_t i = 0; i < count; ++i) {
    int value = int(id.pixels[i * 3]);
    glm::vec3 color = value ? defaultLabelColor(std::uint16_t(value)) : glm::vec3(0.0f);
    for (int c = 0; c < 3; ++c) id.pixels[i * 3 + std::size_t(c)] = color[c];
  }
  io::writeImage(rgb(id), beside("id"));
  // Types of a model in their colours.
  Image type = channelsOf(image, {"type", "type", "type"});
  for (std::size_t i = 0; i * 3 < type.pixels.size(); ++i) {
    float value = type.pixels[i * 3];
    bool isType = value >= 0.0f && value < float(typeColors.size());
    glm::vec3 color = isType ? typeColors[std::size_t(value)] : glm::vec3(0.0f);
    for (int c = 0; c < 3; ++c) type.pixels[i * 3 + std::size_t(c)] = color[c];
  }
  if (!type.pixels.empty()) io::writeImage(rgb(type), beside("type"));
  // Positions within the box of what is hit.
  float low[3] = {1e30f, 1e30f, 1e30f}, high[3] = {-1e30f, -1e30f, -1e30f};
  for (std::size_t i = 0; i < count * 3; ++i)
    if (depth.pixels[i] > 0)
      low[i % 3] = std::min(low[i % 3], position.pixels[i]), high[i % 3] = std::max(high[i % 3], position.pixels[i]);
  for (std::size_t i = 0; i < count * 3; ++i)
    position.pixels[i] =
        depth.pixels[i] > 0 ? (position.pixels[i] - low[i % 3]) / std::max(1e-6f, high[i % 3] - low[i % 3]) : 0.0f;
  io::writeImage(rgb(position), beside("position"));
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
                           const std::filesystem::path& output) {
  std::string command = fmt::format("velum-batch render {} -o {} --size {}x{}", quoted(scene.string()),
                                    quoted(output.string()), options.size.x, options.size.y);
  if (options.samples > 0) command += fmt::format(" --samples {}", options.samples);
  if (options.dpi > 0) command += fmt::format(" --dpi {:g}", options.dpi);
  if (options.transparent) command += " --transparent";
  if (options.layers) command += " --layers";
  return command;
}

scene::Scene sceneForPicture(const scene::Scene& scene, const PictureOptions& options) {
  scene::Scene out = scene;
  if (options.samples > 0) out.rayCast.samplesPerPixel = options.samples;
  if (options.transparent) out.background.transparent = true;
  return out;
}

Image drawPicture(render::Renderer& renderer, const scene::Scene& scene, const PictureOptions& options,
                  const gpu::Limits& limits, Progress& progress) {
  render::Frame frame;
  frame.scene = sceneForPicture(scene, options);
  frame.pictureSize = options.size;
  render::Layers layers;
  if (options.layers) layers = {true, true, true, true, true, bool(scene.model.data)};
  int window = std::min(4096, limits.texture2d);
  Image image = render::renderPicture(renderer, frame, layers, window, progress);
  if (!options.layers || !hasInlayLayers(frame.scene)) return image;
  // As they were drawn: what is put together elsewhere is finished there.
  frame.scene.background.transparent = true;
  frame.scene.finish = {};
  for (const InlayLayer& layer : kInlayLayers) {
    frame.parts = layer.parts;
    image = withChannels(image, render::renderPicture(renderer, frame, {}, window, progress), colorNames(layer.name));
  }
  return image;
}

Image drawSectionPicture(const scene::Scene& scene, scene::SectionKind kind, const PictureOptions& options) {
  render::SectionImage section = render::drawSection(sceneForPicture(scene, options), kind, options.size);
  Image image{section.size.x, section.size.y, {"R", "G", "B", "A"}, {}};
  image.pixels.reserve(section.pixels.size() * 4);
  for (std::uint32_t pixel : section.pixels)
    for (int shift : {16, 8, 0, 24}) image.pixels.push_back(float(pixel >> shift & 255u) / 255.0f);
  return image;
}

void savePicture(const Image& image, const scene::Scene& scene, const PictureOptions& options,
                 const std::filesystem::path& path) {
  scene::Scene drawn = sceneForPicture(scene, options);
  std::string text = sceneTextFor(drawn, path == "-" ? "." : path);
  bool isExr = path.extension() == ".exr";
  if (options.layers && !isExr && path != "-")
    writeLayerPictures(image, scene.model.data ? scene::typeColors(scene.model) : std::vector<glm::vec3>(), path);
  std::vector<std::string> color{"R", "G", "B"};
  if (drawn.background.transparent) color.push_back("A");
  if (!options.layers || !isExr) return io::writeImage(channelsOf(image, color), path, text, options.dpi);
  std::vector<io::ImageAttribute> attributes;
  bool hasTypes =
      scene.model.data && std::find(image.channels.begin(), image.channels.end(), "type") != image.channels.end();
  io::writeImage(hasTypes ? withMattes(image, scene, attributes) : image, path, text, options.dpi, attributes);
}

Image drawPictureHeadless(const scene::Scene& scene, const PictureOptions& options, Progress& progress) {
  auto context = gpu::Context::create(gpu::ContextKind::Auto);
  render::Renderer renderer(*context);
  scene::Scene settled = scene;
  settleMembranes(settled, {}, progress);
  return drawPicture(renderer, settled, options, context->limits(), progress);
}

void renderPictureFile(const scene::Scene& scene, const PictureOptions& options, const std::filesystem::path& path,
                       Progress& progress) {
  savePicture(drawPictureHeadless(scene, options, progress), scene, options, path);
}

}  // namespace velum::session
