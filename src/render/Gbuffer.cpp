#include "render/Gbuffer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "core/Assert.h"

namespace velum::render {

namespace {

/// One texel of it.
struct Texel {
  Texel(glm::vec4 seen, glm::uvec2 packed) : surface(seen), ids(packed) {
    if (ids.y == shared::kDataInstance + 1) {
      face = ids.x >> shared::kFaceShift;
      ids.x &= (1u << shared::kFaceShift) - 1;
    }
  }
  bool isEmpty() const { return ids.y == 0; }

  glm::vec4 surface;
  glm::uvec2 ids;
  std::uint32_t face = 0;  ///< the cut, of those that are enabled, plus 1
};

/// What an instance of the model is of; -1: it is none of the model's.
int typeOf(const FrameData& data, const Texel& texel) {
  bool isOfModel = !texel.isEmpty() && texel.ids.y - 1 >= firstModelInstance(data.frame.scene);
  return isOfModel ? int(texel.ids.x) - int(data.structures.size()) : -1;
}

/// Places in Scene::cuts, plus 1, of those that are enabled, behind a 0.
std::vector<int> enabledCuts(const scene::Scene& scene) {
  std::vector<int> numbers{0};
  for (std::size_t i = 0; i < scene.cuts.size(); ++i)
    if (scene.cuts[i].enabled) numbers.push_back(int(i) + 1);
  return numbers;
}

/// The layers of lines, of a sample as shaders/render/sample.glsl packs it.
void appendLines(const FrameData& data, glm::uvec4 words, std::vector<float>& pixels) {
  constexpr float kSmallestSize = 2.0f;
  bool isSolid = float(words.w >> 24) - 1.0f > 0.5f * 254.0f;
  float depth = std::bit_cast<float>(words.z);
  bool isOrthographic = (data.params.flags & shared::kFlagOrthographic) != 0;
  pixels.push_back(isSolid ? float(int(words.w & 0xffffu) - int(data.structures.size())) : -1.0f);
  pixels.push_back(isSolid ? float((words.w >> 16 & 0xffu) | (words.y >> 16 & 0x3ffu) << 8) : 0.0f);
  pixels.push_back(isSolid ? kSmallestSize * std::exp2(float(words.y >> 26) / 8.0f) : 0.0f);
  pixels.push_back(float(data.unit * double(isOrthographic ? depth : 1.0f / std::max(depth, 1e-9f))));
}

}  // namespace

void Gbuffer::resize(glm::ivec2 size, bool keepsSample) {
  if (!keepsSample) mSample = {};
  if (mColor && this->size() == size && bool(mSample) == keepsSample) return;
  if (keepsSample) mSample = gpu::Texture::make2d("sample", gpu::Format::Rgba32ui, size);
  mColor = gpu::Texture::make2d("colour", gpu::Format::Rgba32f, size);
  mSurface = gpu::Texture::make2d("normal, distance", gpu::Format::Rgba32f, size);
  mIds = gpu::Texture::make2d("structure, instance", gpu::Format::Rg32ui, size);
  mKept = {};
  clear();
}

void Gbuffer::clear() {
  mColor.clear();
  mSurface.clear();
  mIds.clear();
  if (mSample) mSample.clear();
}

void Gbuffer::keepColor() {
  if (!mKept || mKept.size() != mColor.size()) mKept = gpu::Texture::make2d("sums", gpu::Format::Rgba32f, size());
  mKept.copyFrom(mColor, glm::ivec3(0), mColor.size());
}

void Gbuffer::bindImages() const {
  mColor.bindImage(shared::kColorImage, gpu::Access::ReadWrite);
  mSurface.bindImage(shared::kSurfaceImage, gpu::Access::Write);
  mIds.bindImage(shared::kIdImage, gpu::Access::Write);
  if (mSample) mSample.bindImage(shared::kSampleImage, gpu::Access::Write);
}

void Gbuffer::bindSamplers() const {
  mIds.bindSampler(shared::kPictureIdUnit);
  mSurface.bindSampler(shared::kPictureSurfaceUnit);
}

void Gbuffer::appendLayers(const FrameData& data, const Layers& layers, Image& image) const {
  std::size_t before = image.channels.size();
  auto name = [&](bool isWanted, std::initializer_list<const char*> names) {
    if (isWanted) image.channels.insert(image.channels.end(), names.begin(), names.end());
  };
  name(layers.position, {"position.X", "position.Y", "position.Z"});
  name(layers.normal, {"normal.X", "normal.Y", "normal.Z"});
  name(layers.depth, {"Z"});
  name(layers.structure, {"id"});
  name(layers.instance, {"instance"});
  name(layers.type, {"type"});
  name(layers.face, {"face"});
  name(layers.lines, {"lines.type", "lines.part", "lines.size", "lines.depth"});
  if (image.channels.size() == before) return;
  std::size_t count = std::size_t(image.width) * std::size_t(image.height);
  std::vector<glm::vec4> surfaces(count);
  std::vector<glm::uvec2> ids(count);
  mSurface.read(surfaces.data(), count * sizeof(surfaces[0]));
  mIds.read(ids.data(), count * sizeof(ids[0]));
  std::vector<glm::uvec4> samples(layers.lines ? count : 0);
  VELUM_ASSERT(!layers.lines || mSample, "the finish looks at samples");
  if (layers.lines) mSample.read(samples.data(), count * sizeof(samples[0]));
  glm::dvec3 origin = sceneOrigin(data.grid);
  const std::vector<int> cuts = enabledCuts(data.frame.scene);
  std::vector<float> pixels;
  pixels.reserve(count * image.channels.size());
  for (std::size_t i = 0; i < count; ++i) {
    Texel texel{surfaces[i], ids[i]};
    auto* own = &image.pixels[i * before];
    pixels.insert(pixels.end(), own, own + before);
    auto append = [&](glm::dvec3 v) {
      for (int c = 0; c < 3; ++c) pixels.push_back(float(v[c]));
    };
    float distance = texel.isEmpty() ? std::numeric_limits<float>::infinity() : texel.surface.w;
    glm::ivec2 pixel(int(i) % image.width, int(i) / image.width);
    glm::vec3 point(0.0f);
    if (!texel.isEmpty() && layers.position)
      point = glm::vec3(pointOnRay(data.params, pixel + data.frame.windowOrigin, distance));
    if (layers.position) append(texel.isEmpty() ? glm::dvec3(0.0) : data.unit * (origin + glm::dvec3(point)));
    if (layers.normal) append(glm::dvec3(glm::vec3(texel.surface)));
    if (layers.depth) pixels.push_back(float(data.unit * double(distance)));
    int type = typeOf(data, texel);
    if (layers.structure) pixels.push_back(type < 0 ? float(texel.ids.x) : 0.0f);
    if (layers.instance) pixels.push_back(texel.isEmpty() ? -1.0f : float(texel.ids.y - 1));
    if (layers.type) pixels.push_back(float(type));
    if (layers.face) pixels.push_back(texel.face < cuts.size() ? float(cuts[texel.face]) : 0.0f);
    if (layers.lines) appendLines(data, samples[i], pixels);
  }
  image.pixels = std::move(pixels);
}

Pick Gbuffer::pick(const FrameData& data, glm::ivec2 pixel) const {
  Pick pick;
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size().x || pixel.y >= size().y) return pick;
  glm::vec4 surface(0.0f);
  glm::uvec2 ids(0);
  mSurface.read({pixel, 0}, {1, 1, 1}, &surface, sizeof(surface));
  mIds.read({pixel, 0}, {1, 1, 1}, &ids, sizeof(ids));
  Texel texel(surface, ids);
  if (texel.isEmpty()) return pick;
  pick.hit = true;
  glm::dvec3 onRay(pointOnRay(data.params, pixel + data.frame.windowOrigin, texel.surface.w));
  pick.world = data.unit * (sceneOrigin(data.grid) + onRay);
  pick.normal = glm::vec3(texel.surface);
  pick.structure = int(texel.ids.x);
  pick.instance = texel.ids.y - 1;
  pick.type = typeOf(data, texel);
  if (pick.type >= 0) {
    pick.structure = 0;
    pick.modelInstance = pick.instance - firstModelInstance(data.frame.scene);
  }
  if (const auto& layer = data.frame.scene.volume; layer.data) {
    glm::dvec3 voxel(glm::inverse(layer.data->worldFromVoxel) * glm::dvec4(pick.world, 1.0));
    glm::ivec3 nearest = glm::clamp(glm::ivec3(glm::floor(voxel + 0.5)), glm::ivec3(0), layer.data->dims - 1);
    pick.value = valueAt(*layer.data, nearest, layer.channel, layer.timeStep);
  }
  return pick;
}

PixelIds Gbuffer::idsOfPixels(const FrameData& data, bool withDistances) const {
  std::vector<glm::uvec2> ids(std::size_t(size().x) * std::size_t(size().y));
  mIds.read(ids.data(), ids.size() * sizeof(ids[0]));
  PixelIds out;
  bool hasModel = bool(data.frame.scene.model.data);
  out.structures.reserve(ids.size());
  if (hasModel) out.types.reserve(ids.size()), out.instances.reserve(ids.size());
  for (const glm::uvec2& id : ids) {
    Texel texel{glm::vec4(0.0f), id};
    int type = typeOf(data, texel);
    out.structures.push_back(texel.isEmpty() ? -1 : type < 0 ? std::int32_t(texel.ids.x) : 0);
    if (!hasModel) continue;
    out.types.push_back(type);
    out.instances.push_back(type < 0 ? -1 : std::int32_t(texel.ids.y - 1 - firstModelInstance(data.frame.scene)));
  }
  if (!withDistances) return out;
  std::vector<glm::vec4> surfaces(ids.size());
  mSurface.read(surfaces.data(), surfaces.size() * sizeof(surfaces[0]));
  out.distances.reserve(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    bool isEmpty = Texel{surfaces[i], ids[i]}.isEmpty();
    out.distances.push_back(isEmpty ? std::numeric_limits<float>::infinity()
                                    : float(data.unit * double(surfaces[i].w)));
  }
  return out;
}

}  // namespace velum::render
