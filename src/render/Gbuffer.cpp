#include "render/Gbuffer.h"

#include <cmath>
#include <limits>
#include <vector>

#include "core/Assert.h"
#include "shared/cut.h"

namespace velum::render {

namespace {

/// One texel of it.
struct Texel {
  glm::vec4 surface{0.0f};
  glm::uvec2 ids{0};
  bool isEmpty() const { return ids.y == 0; }
};

/// What an instance of the model is of; -1: it is none of the model's.
int typeOf(const FrameData& data, const Texel& texel) {
  bool isOfModel = !texel.isEmpty() && texel.ids.y - 1 >= firstModelInstance(data.frame.scene);
  return isOfModel ? int(texel.ids.x) - int(data.structures.size()) : -1;
}

/// The unit normal of the face of a cut that is no membrane, out of the material.
glm::vec3 faceNormal(const shared::CutData& cut, glm::vec3 point, float step) {
  glm::vec3 gradient(0.0f);
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 way(0.0f);
    way[axis] = step;
    gradient[axis] = shared::shapeDistance(cut, point + way) - shared::shapeDistance(cut, point - way);
  }
  float length = glm::length(gradient);
  return length > 0.0f ? -gradient / length : glm::vec3(0.0f);
}

/// The cut on whose face a place of the data lies: its place in Scene::cuts, plus 1; 0: none. Within a voxel, as
/// material may begin to show some steps behind a face, and looking as the face does.
int faceAt(const FrameData& data, const Texel& texel, glm::vec3 point) {
  if (texel.isEmpty() || texel.ids.y - 1 != shared::kDataInstance) return 0;
  constexpr float kAlike = 0.9f;
  bool hasNormals = (data.params.flags & shared::kFlagShaded) != 0;
  float voxel = 1.0f / data.params.voxelsPerLength;
  int number = 0;
  std::size_t enabled = 0;
  for (const scene::Cut& cut : data.frame.scene.cuts) {
    ++number;
    if (!cut.enabled) continue;
    VELUM_ASSERT(enabled < data.cuts.size(), "the frame has all cuts that are enabled");
    const shared::CutData& face = data.cuts[enabled++];
    float reach = hasNormals ? voxel : 0.5f * voxel;
    if (face.kind.x == shared::kCutMembrane || std::abs(shared::shapeDistance(face, point)) > reach) continue;
    bool isAlike = glm::dot(faceNormal(face, point, 0.05f * voxel), glm::vec3(texel.surface)) > kAlike;
    if (isAlike || !hasNormals) return number;
  }
  return 0;
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
  if (image.channels.size() == before) return;
  std::size_t count = std::size_t(image.width) * std::size_t(image.height);
  std::vector<glm::vec4> surfaces(count);
  std::vector<glm::uvec2> ids(count);
  mSurface.read(surfaces.data(), count * sizeof(surfaces[0]));
  mIds.read(ids.data(), count * sizeof(ids[0]));
  glm::dvec3 origin = sceneOrigin(data.grid);
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
    if (!texel.isEmpty() && (layers.position || layers.face))
      point = glm::vec3(pointOnRay(data.params, pixel + data.frame.windowOrigin, distance));
    if (layers.position) append(texel.isEmpty() ? glm::dvec3(0.0) : data.unit * (origin + glm::dvec3(point)));
    if (layers.normal) append(glm::dvec3(glm::vec3(texel.surface)));
    if (layers.depth) pixels.push_back(float(data.unit * double(distance)));
    int type = typeOf(data, texel);
    if (layers.structure) pixels.push_back(type < 0 ? float(texel.ids.x) : 0.0f);
    if (layers.instance) pixels.push_back(texel.isEmpty() ? -1.0f : float(texel.ids.y - 1));
    if (layers.type) pixels.push_back(float(type));
    if (layers.face) pixels.push_back(float(faceAt(data, texel, point)));
  }
  image.pixels = std::move(pixels);
}

Pick Gbuffer::pick(const FrameData& data, glm::ivec2 pixel) const {
  Pick pick;
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size().x || pixel.y >= size().y) return pick;
  Texel texel;
  mSurface.read({pixel, 0}, {1, 1, 1}, &texel.surface, sizeof(texel.surface));
  mIds.read({pixel, 0}, {1, 1, 1}, &texel.ids, sizeof(texel.ids));
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
  for (const glm::uvec2& id : ids) {
    Texel texel{glm::vec4(0.0f), id};
    int type = typeOf(data, texel);
    out.structures.push_back(texel.isEmpty() ? -1 : type < 0 ? std::int32_t(id.x) : 0);
    if (!data.frame.scene.model.data) continue;
    out.types.push_back(type);
    out.instances.push_back(type < 0 ? -1 : std::int32_t(id.y - 1 - firstModelInstance(data.frame.scene)));
  }
  if (!withDistances) return out;
  std::vector<glm::vec4> surfaces(ids.size());
  mSurface.read(surfaces.data(), surfaces.size() * sizeof(surfaces[0]));
  for (std::size_t i = 0; i < ids.size(); ++i) {
    bool isEmpty = Texel{surfaces[i], ids[i]}.isEmpty();
    out.distances.push_back(isEmpty ? std::numeric_limits<float>::infinity()
                                    : float(data.unit * double(surfaces[i].w)));
  }
  return out;
}

}  // namespace velum::render
