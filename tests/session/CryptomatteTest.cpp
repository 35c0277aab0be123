#include "session/picture/Cryptomatte.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "TempFolder.h"
#include "makeModel.h"
#include "session/picture/Picture.h"

namespace velum::session {
namespace {

scene::Scene modelScene() {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(ModelMaker{.types = 3, .instances = 30}.make());
  scene.model.copies = 2;
  scene.surfaces.resize(2);
  return scene;
}

/// A pixel of nothing, one of a surface, and two of the model: of its first instance, and of its last one in the
/// second copy.
Image layersOf(const scene::Scene& scene) {
  float last = float(3 + 2 * scene.model.data->instances.size() - 1);
  Image image{4,
              1,
              {"R", "G", "B", "A", "position.X", "position.Y", "position.Z", "normal.X", "normal.Y", "normal.Z", "Z",
               "id", "instance", "type"},
              {}};
  for (auto [instance, type] : {std::pair(-1.0f, -1.0f), {1.0f, -1.0f}, {3.0f, 0.0f}, {last, 2.0f}}) {
    image.pixels.insert(image.pixels.end(), {0.5f, 0.25f, 1.0f, 1.0f, 1, 2, 3, 0, 0, 1, 9, 0});
    image.pixels.insert(image.pixels.end(), {instance, type});
  }
  return image;
}

float valueAt(const Image& image, int pixel, const std::string& channel) {
  auto found = std::find(image.channels.begin(), image.channels.end(), channel);
  if (found == image.channels.end()) throw std::runtime_error("no channel " + channel);
  return image.pixels[std::size_t(pixel) * image.channels.size() + std::size_t(found - image.channels.begin())];
}

std::string attributeOf(const std::vector<io::ImageAttribute>& attributes, const std::string& name) {
  for (const auto& attribute : attributes)
    if (attribute.name == name) return attribute.value;
  return "none";
}

std::string keyOf(const std::string& name) {
  return fmt::format("cryptomatte/{:.7}/", fmt::format("{:08x}", cryptoHash(name)));
}

TEST(Cryptomatte, HashesAreThoseOfTheSpecification) {
  // Its own examples.
  EXPECT_EQ(cryptoHash("bunny"), 0x13851a76u);
  EXPECT_EQ(cryptoHash("default"), 0x42c9679fu);
  EXPECT_EQ(cryptoHash("bunny_porcelain_mat"), 0xb24b26d4u);
  EXPECT_EQ(cryptoHash(""), 0u);
}

TEST(Cryptomatte, NumbersKeepTheBitsButNoneThatIsSpecial) {
  EXPECT_EQ(std::bit_cast<std::uint32_t>(cryptoNumber(0x13851a76u)), 0x13851a76u);
  for (std::uint32_t hash : {0u, 0x7f800000u, 0xff800001u, 0x007fffffu, 0x80000000u, 0xffffffffu})
    EXPECT_EQ(std::fpclassify(cryptoNumber(hash)), FP_NORMAL) << hash;
  EXPECT_EQ(std::bit_cast<std::uint32_t>(cryptoNumber(0xffffffffu)), 0xff7fffffu);
  EXPECT_EQ(std::bit_cast<std::uint32_t>(cryptoNumber(0x80000005u)), 0x80800005u);
}

TEST(Cryptomatte, EachPixelHasTheHashOfWhatIsSeenAndTheManifestItsName) {
  scene::Scene scene = modelScene();
  const Model& model = *scene.model.data;
  std::vector<io::ImageAttribute> attributes;
  Image image = withMattes(layersOf(scene), scene, attributes);
  EXPECT_EQ(image.pixels.size(), 4 * image.channels.size());
  std::string first = pathOf(model, model.types[0]), last = pathOf(model, model.types[2]);
  std::map<std::string, std::string> names{{"CryptoType", first}, {"CryptoInstance", first + " 0"}},
      others{{"CryptoType", last}, {"CryptoInstance", last + " 59"}};
  for (const std::string matte : {"CryptoType", "CryptoInstance"}) {
    for (int empty : {0, 1})
      for (const char* end : {"00.r", "00.g", "00.b", "00.a"}) EXPECT_EQ(valueAt(image, empty, matte + end), 0.0f);
    EXPECT_EQ(valueAt(image, 2, matte + "00.r"), cryptoNumber(cryptoHash(names[matte])));
    EXPECT_EQ(valueAt(image, 3, matte + "00.r"), cryptoNumber(cryptoHash(others[matte])));
    EXPECT_EQ(valueAt(image, 3, matte + "00.g"), 1.0f);
    EXPECT_EQ(valueAt(image, 3, matte + "00.b"), 0.0f);
    EXPECT_EQ(valueAt(image, 3, matte + "00.a"), 0.0f);
    EXPECT_EQ(attributeOf(attributes, keyOf(matte) + "name"), matte);
    EXPECT_EQ(attributeOf(attributes, keyOf(matte) + "hash"), "MurmurHash3_32");
    EXPECT_EQ(attributeOf(attributes, keyOf(matte) + "conversion"), "uint32_to_float32");
    auto manifest = nlohmann::json::parse(attributeOf(attributes, keyOf(matte) + "manifest"));
    ASSERT_EQ(manifest.size(), 2u);
    float id = valueAt(image, 3, matte + "00.r");
    EXPECT_EQ(manifest[others[matte]], fmt::format("{:08x}", std::bit_cast<std::uint32_t>(id)));
  }
}

TEST(Cryptomatte, AnExrHoldsThemBitByBitWithTheirNames) {
  scene::Scene scene = modelScene();
  TempFolder folder;
  PictureOptions options{{4, 1}, 1, false, true, 0};
  Image image = layersOf(scene);
  savePicture(image, scene, options, folder / "a.exr");
  Image back = io::readImage(folder / "a.exr");
  std::vector<io::ImageAttribute> attributes;
  Image wanted = withMattes(image, scene, attributes);
  ASSERT_GE(attributes.size(), 4u) << "name, hash, conversion and manifest";
  ASSERT_GT(wanted.channels.size(), image.channels.size() + 3);
  for (int pixel = 0; pixel < 4; ++pixel)
    for (const std::string& channel : wanted.channels) {
      if (channel.size() == 1) continue;  // colour is kept in another form
      EXPECT_EQ(valueAt(back, pixel, channel), valueAt(wanted, pixel, channel)) << channel;
    }
  std::ifstream in(folder / "a.exr", std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  for (const auto& attribute : attributes) {
    // An attribute of OpenEXR: name, type, length, value.
    std::size_t at = bytes.find(attribute.name + std::string("\0string\0", 8));
    ASSERT_NE(at, std::string::npos) << attribute.name;
    EXPECT_EQ(bytes.substr(at + attribute.name.size() + 8 + 4, attribute.value.size()), attribute.value);
    EXPECT_LE(attribute.name.size(), 31u) << "longer ones are not read by all";
  }
}

TEST(Cryptomatte, BesideAPngTypesHaveTheirColours) {
  scene::Scene scene = modelScene();
  TempFolder folder;
  savePicture(layersOf(scene), scene, {{4, 1}, 1, false, true, 0}, folder / "a.png");
  Image types = io::readImage(folder / "a.type.png");
  glm::vec3 color = scene::typeColors(scene.model)[2];
  for (int c = 0; c < 3; ++c) {
    EXPECT_EQ(types.pixels[std::size_t(c)], 0.0f);
    EXPECT_NEAR(types.pixels[std::size_t(9 + c)], color[c], 0.5f / 255.0f + 1e-6f);
  }
}

}  // namespace
}  // namespace velum::session
