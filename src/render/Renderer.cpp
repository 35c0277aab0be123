#include "velum/render/Renderer.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "RendererImpl.h"
#include "velum/core/Clock.h"
#include "velum/gpu/Scope.h"

namespace velum::render {

namespace {

constexpr double kLongestTileMs = 8.0;
constexpr int kSmallestTile = 16;

}  // namespace

Renderer::Renderer(gpu::Context& context) : mImpl(std::make_unique<Impl>(context)) {
  mImpl->stats.renderer = context.limits().renderer;
}
Renderer::~Renderer() = default;

const Stats& Renderer::stats() const { return mImpl->stats; }

double Renderer::fractionDone() const {
  const Impl& m = *mImpl;
  return m.stepCount ? 1.0 - double(m.steps.size()) / double(m.stepCount) : 1.0;
}

void Renderer::clear() {
  gpu::Context& context = mImpl->context;
  Stats stats = mImpl->stats;
  mImpl = std::make_unique<Impl>(context);
  mImpl->stats = stats;
}

void Renderer::Impl::begin(const Frame& next) {
  wanted = next;
  frame = next;
  if (frame.windowSize == glm::ivec2(0)) frame.windowSize = frame.pictureSize;
  frame.windowSize = glm::max(frame.windowSize, glm::ivec2(1));
  frame.pictureSize = glm::max(frame.pictureSize, glm::ivec2(1));
  steps.clear();
  passMs.clear();
  stats.frameMs = 0;
  stats.longestStepMs = 0;
  stats.samples = 0;
  currentSample = 0;
  rowsDone = 0;
  part = glm::ivec3(0);
  addUploadSteps();
  steps.push_back({"Setup", [this] {
                     setup();
                     addLightSteps();
                     addTileSteps();
                     stepCount = steps.size();
                     return true;
                   }});
  stepCount = steps.size();
}

void Renderer::Impl::castTile(glm::ivec4 rect) {
  sum.bindImage(0, gpu::Access::ReadWrite);
  hits.bindImage(1, gpu::Access::Write);
  glm::ivec2 groups = (glm::ivec2(rect.z, rect.w) + shared::kTileGroup - 1) / shared::kTileGroup;
  // Near the golden section of their number, and with no common factor: any run of groups is spread over the tile.
  int count = groups.x * groups.y, stride = std::max(1, int(0.618 * count));
  while (std::gcd(stride, count) != 1) ++stride;
  rayProgram->set(0, rect);
  rayProgram->set(1, frame.windowOrigin);
  rayProgram->set(2, stride);
  gpu::dispatch(*rayProgram, glm::ivec3(groups, 1));
  gpu::barrier();
}

/// Tiles of the next picture are such that none of them keeps the window waiting; no pixel depends on their size.
void Renderer::Impl::adaptTileSize() {
  if (frame.isPreview) return;
  if (longestTileMs > kLongestTileMs)
    tileSize = std::max(kSmallestTile, tileSize / 2);
  else if (longestTileMs < 0.2 * kLongestTileMs)
    tileSize = std::min(firstTileSize(), tileSize * 2);
  longestTileMs = 0;
}

void Renderer::Impl::addTileSteps() {
  adaptTileSize();
  glm::ivec2 size = frame.windowSize;
  // Where neither the volume's box nor a surface can be, rays have nothing to do.
  glm::ivec4 covered = frame.scene.surfaces.empty() ? coveredRect(params, frame) : glm::ivec4(0, 0, size);
  for (int sample = 0; sample < std::max(1, frame.scene.rayCast.samplesPerPixel); ++sample) {
    steps.push_back({"Surfaces", [this, sample, size] {
                       currentSample = sample;
                       rowsDone = 0;
                       part = glm::ivec3(0);
                       if (sample == 0) sum.clear(), hits.clear();
                       setSample(params, frame, sample);
                       frameBlock.set(params);
                       surfaces->draw(frame.scene, sceneOrigin(grid), grid.worldFromTex, size);
                       surfaces->bind();
                       return true;
                     }});
    for (int y = covered.y; y < covered.y + covered.w; y += tileSize)
      for (int x = covered.x; x < covered.x + covered.z; x += tileSize) {
        glm::ivec4 rect(x, y, std::min(tileSize, covered.x + covered.z - x),
                        std::min(tileSize, covered.y + covered.w - y));
        bool lastOfRow = x + tileSize >= covered.x + covered.z;
        steps.push_back({"RayCast", [this, rect, lastOfRow] {
                           castTile(rect);
                           part = {rect.y, rect.y + rect.w, rect.x + rect.z};
                           if (lastOfRow) rowsDone = rect.y + rect.w;
                           return true;
                         }});
      }
    steps.push_back({"RayCast", [this, sample] {
                       stats.samples = sample + 1;
                       return true;
                     }});
  }
}

void Renderer::Impl::resizePictures(glm::ivec2 size) {
  if (sum && glm::ivec2(sum.size()) == size) return;
  sum = gpu::Texture::make2d("sum of samples", gpu::Format::Rgba32f, size);
  hits = gpu::Texture::make2d("distance, normal, structure", gpu::Format::Rgba32f, size);
  picture = gpu::Texture::make2d("picture", gpu::Format::Rgba8, size, gpu::Filter::Linear);
  pictureTarget = gpu::Framebuffer("picture", {&picture});
  sum.clear();
}

bool Renderer::work(const Frame& frame, double budgetMs) {
  Impl& m = *mImpl;
  auto start = Clock::now();
  if (!m.wanted || !(*m.wanted == frame)) m.begin(frame);
  if (m.steps.empty()) return true;
  std::string_view first = m.steps.front().pass;
  if (m.rayProgram && first != "Upload" && first != "Setup") {
    m.bindAll();
    m.surfaces->bind();
  }
  do {
    auto stepStart = Clock::now();
    Step step = m.steps.front();
    gpu::Scope scope(nullptr, step.pass);
    bool done = step.run();
    gpu::finish();
    double ms = msSince(stepStart);
    m.passMs[step.pass] += ms;
    if (std::string_view(step.pass) == "Upload")
      m.stats.uploadMs += ms;
    else
      m.stats.frameMs += ms;
    m.stats.longestStepMs = std::max(m.stats.longestStepMs, ms);
    if (std::string_view(step.pass) == "RayCast" && !frame.isPreview) m.longestTileMs = std::max(m.longestTileMs, ms);
    if (done) m.steps.pop_front();
  } while (!m.steps.empty() && msSince(start) < budgetMs);
  if (m.steps.empty()) m.stats.passesMs = m.passMs;
  return m.steps.empty();
}

void Renderer::render(const Frame& frame, Progress& progress) {
  while (!work(frame, 100.0)) progress.report(fractionDone(), "rendering");
}

void Renderer::Impl::resolve() {
  if (!resolveProgram) resolveProgram.emplace(gpu::Program({"render/resolve.comp"}));
  const auto& background = frame.scene.background;
  frameBlock.bind(shared::kFrameBinding);
  sum.bindImage(0, gpu::Access::Read);
  picture.bindImage(1, gpu::Access::Write);
  bool complete = steps.empty();
  resolveProgram->set(0, frame.windowOrigin);
  resolveProgram->set(1, complete ? stats.samples : currentSample);
  resolveProgram->set(2, complete ? 0 : rowsDone);
  resolveProgram->set(3, complete ? glm::ivec2(0) : glm::ivec2(part));
  resolveProgram->set(4, complete ? 0 : part.z);
  float backdrop = background.transparent ? 0.0f : 1.0f;
  resolveProgram->set(5, glm::vec4(background.top, backdrop));
  resolveProgram->set(6, glm::vec4(background.bottom, backdrop));
  gpu::dispatch(*resolveProgram, {(frame.windowSize.x + 7) / 8, (frame.windowSize.y + 7) / 8, 1});
  gpu::barrier();
}

void Renderer::present(unsigned framebuffer, glm::ivec2 size) {
  Impl& m = *mImpl;
  if (!m.sum || !m.rayProgram) return;
  m.resolve();
  gpu::present(m.pictureTarget, framebuffer, size);
}

/// @param pixel  of the window
Hit Renderer::Impl::hitAt(glm::ivec2 pixel, glm::vec4 texel) const {
  Hit hit;
  if (texel.w < 0.5f) return hit;
  hit.found = true;
  hit.distance = texel.x;
  hit.scenePoint = pointOnRay(params, pixel + frame.windowOrigin, hit.distance);
  // Octahedral: the square's corners are the lower half, folded out.
  glm::vec3 n(texel.y, texel.z, 1.0f - std::abs(texel.y) - std::abs(texel.z));
  if (n.z < 0) {
    glm::vec2 folded = 1.0f - glm::abs(glm::vec2(n.y, n.x));
    n.x = std::copysign(folded.x, n.x);
    n.y = std::copysign(folded.y, n.y);
  }
  hit.normal = glm::normalize(n);
  hit.structure = int(texel.w - 0.5f);
  return hit;
}

Image Renderer::read(const Layers& layers) {
  Impl& m = *mImpl;
  Image image;
  if (!m.sum) return image;
  m.resolve();
  glm::ivec2 size = m.frame.windowSize;
  image.width = size.x;
  image.height = size.y;
  image.channels = {"R", "G", "B", "A"};
  if (layers.position) image.channels.insert(image.channels.end(), {"position.X", "position.Y", "position.Z"});
  if (layers.normal) image.channels.insert(image.channels.end(), {"normal.X", "normal.Y", "normal.Z"});
  if (layers.depth) image.channels.push_back("Z");
  if (layers.structure) image.channels.push_back("id");
  std::size_t count = std::size_t(size.x) * std::size_t(size.y), channels = image.channels.size();
  image.pixels.resize(count * channels);
  std::vector<glm::u8vec4> color(count);
  std::vector<glm::vec4> hits(count);
  m.picture.read(color.data(), count * sizeof(color[0]));
  if (channels > 4) m.hits.read(hits.data(), count * sizeof(hits[0]));
  glm::dvec3 origin = sceneOrigin(m.grid);
  for (std::size_t i = 0; i < count; ++i) {
    float* out = &image.pixels[i * channels];
    float alpha = float(color[i].a) / 255.0f;
    for (int c = 0; c < 3; ++c) *out++ = alpha > 0.0f ? std::min(1.0f, float(color[i][c]) / 255.0f / alpha) : 0.0f;
    *out++ = alpha;
    if (channels == 4) continue;
    Hit hit = m.hitAt({int(i) % size.x, int(i) / size.x}, hits[i]);
    if (layers.position)
      for (int c = 0; c < 3; ++c) *out++ = hit.found ? float(double(hit.scenePoint[c]) + origin[c]) : 0.0f;
    if (layers.normal)
      for (int c = 0; c < 3; ++c) *out++ = hit.normal[c];
    if (layers.depth) *out++ = hit.distance;
    if (layers.structure) *out++ = float(hit.structure);
  }
  return image;
}

Pick Renderer::pick(glm::ivec2 pixel) const {
  const Impl& m = *mImpl;
  Pick pick;
  if (!m.hits || pixel.x < 0 || pixel.y < 0 || pixel.x >= m.frame.windowSize.x || pixel.y >= m.frame.windowSize.y)
    return pick;
  glm::vec4 texel;
  m.hits.read({pixel, 0}, {1, 1, 1}, &texel, sizeof(texel));
  Hit hit = m.hitAt(pixel, texel);
  if (!hit.found) return pick;
  pick.hit = true;
  pick.worldMm = glm::dvec3(hit.scenePoint) + sceneOrigin(m.grid);
  pick.normal = hit.normal;
  pick.structure = hit.structure;
  if (const auto& data = m.frame.scene.volume.data) {
    glm::dvec3 voxel(glm::inverse(data->worldFromVoxel) * glm::dvec4(pick.worldMm, 1.0));
    glm::ivec3 nearest = glm::clamp(glm::ivec3(glm::floor(voxel + 0.5)), glm::ivec3(0), data->dims - 1);
    pick.value = valueAt(*data, nearest, m.frame.scene.volume.channel, m.frame.scene.volume.frame);
  }
  return pick;
}

Image renderPicture(Renderer& renderer, const Frame& frame, const Layers& layers, int largestWindow,
                    Progress& progress) {
  Image whole;
  glm::ivec2 size = frame.pictureSize;
  int columns = (size.x + largestWindow - 1) / largestWindow, rows = (size.y + largestWindow - 1) / largestWindow;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      Frame part = frame;
      part.windowOrigin = glm::ivec2(column, row) * largestWindow;
      part.windowSize = glm::min(size - part.windowOrigin, glm::ivec2(largestWindow));
      renderer.render(part, progress);
      Image image = renderer.read(layers);
      if (columns * rows == 1) return image;
      if (whole.pixels.empty()) {
        whole = {size.x, size.y, image.channels, {}};
        whole.pixels.resize(std::size_t(size.x) * std::size_t(size.y) * image.channels.size());
      }
      std::size_t rowFloats = std::size_t(image.width) * image.channels.size();
      for (int y = 0; y < image.height; ++y)
        std::copy_n(image.pixels.begin() + std::ptrdiff_t(std::size_t(y) * rowFloats), rowFloats,
                    whole.pixels.begin() + std::ptrdiff_t((std::size_t(y + part.windowOrigin.y) * std::size_t(size.x) +
                                                           std::size_t(part.windowOrigin.x)) *
                                                          image.channels.size()));
    }
  return whole;
}

}  // namespace velum::render
