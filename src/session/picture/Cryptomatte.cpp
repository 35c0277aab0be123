#include "session/picture/Cryptomatte.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/Assert.h"
#include "core/ImageChannels.h"
#include "scene/Crowd.h"
#include "scene/Scene.h"

namespace velum::session {

namespace {

std::uint32_t mixed(std::uint32_t word) { return std::rotl(word * 0xcc9e2d51u, 15) * 0x1b873593u; }

/// A layer, and what of each pixel it is of.
struct Matte {
  std::string name;                                     ///< "CryptoType"
  std::function<std::string(std::size_t what)> nameOf;  ///< For people, and hashed.
  std::map<std::size_t, float> ids;                     ///< Of what is seen.
  nlohmann::ordered_json manifest = nlohmann::ordered_json::object();

  float idOf(std::size_t what) {
    auto [found, isNew] = ids.try_emplace(what, 0.0f);
    if (isNew) {
      std::string text = nameOf(what);
      found->second = cryptoNumber(cryptoHash(text));
      manifest[text] = fmt::format("{:08x}", std::bit_cast<std::uint32_t>(found->second));
    }
    return found->second;
  }

  void addAttributes(std::vector<io::ImageAttribute>& to) const {
    std::string key = fmt::format("cryptomatte/{:.7}/", fmt::format("{:08x}", cryptoHash(name)));
    to.push_back({key + "name", name});
    to.push_back({key + "hash", "MurmurHash3_32"});
    to.push_back({key + "conversion", "uint32_to_float32"});
    to.push_back({key + "manifest", manifest.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)});
  }
};

std::size_t columnOf(const Image& image, std::string_view name) {
  std::ptrdiff_t column = channelIndex(image, name);
  VELUM_ASSERT(column >= 0, "the picture has the layers that mattes are made of");
  return std::size_t(column);
}

}  // namespace

std::uint32_t cryptoHash(std::string_view name) {
  auto byte = [&](std::size_t at) { return std::uint32_t(static_cast<unsigned char>(name[at])); };
  std::uint32_t hash = 0;
  std::size_t at = 0;
  for (; at + 4 <= name.size(); at += 4) {
    hash ^= mixed(byte(at) | byte(at + 1) << 8 | byte(at + 2) << 16 | byte(at + 3) << 24);
    hash = std::rotl(hash, 13) * 5u + 0xe6546b64u;
  }
  std::uint32_t rest = 0;
  for (std::size_t i = name.size(); i > at; --i) rest = rest << 8 | byte(i - 1);
  hash ^= mixed(rest) ^ std::uint32_t(name.size());
  hash = (hash ^ hash >> 16) * 0x85ebca6bu;
  hash = (hash ^ hash >> 13) * 0xc2b2ae35u;
  return hash ^ hash >> 16;
}

float cryptoNumber(std::uint32_t hash) {
  std::uint32_t exponent = std::clamp(hash >> 23 & 0xffu, 1u, 254u);
  return std::bit_cast<float>((hash & 0x807fffffu) | exponent << 23);
}

Image withMattes(const Image& image, const scene::Scene& scene, std::vector<io::ImageAttribute>& attributes) {
  const Model& model = *scene.model.data;
  // Instances are counted behind the volume and the surfaces, see render::Pick.
  const std::size_t firstInstance = 1 + scene.surfaces.size();
  std::vector<std::string> paths;
  for (const MoleculeType& type : model.types) paths.push_back(pathOf(model, type));
  Matte types{"CryptoType", [&](std::size_t type) { return paths[type]; }, {}, {}};
  // Numbers are of copies in a crowd, of which a type is seen.
  const bool isCrowd = scene::isCrowd(scene.model);
  Matte instances{"CryptoInstance",
                  [&](std::size_t instance) {
                    if (isCrowd) return fmt::format("copy {}", instance);
                    const Instance& of = model.instances[instance % model.instances.size()];
                    return fmt::format("{} {}", paths[model.molecules[of.molecule].type], instance);
                  },
                  {},
                  {}};
  types.manifest = instances.manifest = nlohmann::ordered_json::object();
  Image out{image.width, image.height, image.channels, {}};
  for (const Matte* matte : {&types, &instances})
    for (const char* end : {"00.r", "00.g", "00.b", "00.a"}) out.channels.push_back(matte->name + end);
  const std::size_t count = std::size_t(image.width) * std::size_t(image.height), width = image.channels.size(),
                    typeColumn = columnOf(image, "type"), instanceColumn = columnOf(image, "instance");
  out.pixels.reserve(count * out.channels.size());
  for (std::size_t i = 0; i < count; ++i) {
    const float* pixel = &image.pixels[i * width];
    out.pixels.insert(out.pixels.end(), pixel, pixel + width);
    bool isOfModel = pixel[typeColumn] >= 0.0f && pixel[instanceColumn] >= float(firstInstance);
    if (!isOfModel) {
      out.pixels.insert(out.pixels.end(), 8, 0.0f);
      continue;
    }
    float type = types.idOf(std::size_t(pixel[typeColumn])),
          instance = instances.idOf(std::size_t(pixel[instanceColumn]) - firstInstance);
    out.pixels.insert(out.pixels.end(), {type, 1.0f, 0.0f, 0.0f, instance, 1.0f, 0.0f, 0.0f});
  }
  types.addAttributes(attributes);
  instances.addAttributes(attributes);
  return out;
}

}  // namespace velum::session
