// Named finishes and the lit spheres that they use.
#include "scene/Finishes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "core/Error.h"
#include "scene/LitSpheres.h"
#include "scene/ModelLooks.h"
#include "scene/Presets.h"

namespace velum::scene {
namespace {

double meanDifference(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::abs(double(a.pixels[i]) - double(b.pixels[i]));
  return sum / double(a.pixels.size());
}

TEST(LitSpheres, ThereAreEnoughOfThem) { EXPECT_GE(litSpheres().size(), 24u); }

TEST(LitSpheres, EachIsItsOwn) {
  std::set<std::string_view> names, titles;
  for (const auto& a : litSpheres()) {
    names.insert(a.name);
    titles.insert(a.title);
    for (const auto& b : litSpheres())
      if (a.name < b.name) {
        EXPECT_GT(meanDifference(makeLitSphere(a.name, 32), makeLitSphere(b.name, 32)), 0.02)
            << a.name << ", " << b.name;
      }
  }
  EXPECT_EQ(names.size(), litSpheres().size());
  EXPECT_EQ(titles.size(), litSpheres().size());
}

TEST(LitSpheres, EachIsSmoothAndWithinItsRange) {
  for (const auto& sphere : litSpheres()) {
    Image image = makeLitSphere(sphere.name);
    ASSERT_EQ(image.pixels.size(), std::size_t(kLitSphereSize * kLitSphereSize * 3));
    float largest = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x + 1 < image.width; ++x)
        for (int c = 0; c < 3; ++c) {
          auto at = std::size_t((y * image.width + x) * 3 + c);
          ASSERT_GE(image.pixels[at], 0.0f);
          ASSERT_LE(image.pixels[at], 1.0f);
          // Near the rim a pixel is a large part of the way round.
          float dx = float(x) - 63.5f, dy = float(y) - 63.5f;
          if (dx * dx + dy * dy < 56 * 56)
            largest = std::max(largest, std::abs(image.pixels[at + 3] - image.pixels[at]));
        }
    EXPECT_LT(largest, 0.13f) << sphere.name;
  }
}

TEST(LitSpheres, LightComesFromTheUpperLeft) {
  for (const char* name : {"bone", "skin", "muscle", "clay", "plaster", "charcoal"}) {
    auto brightness = [&](glm::vec3 n) { return glm::dot(litSphereColor(name, glm::normalize(n)), glm::vec3(1.0f)); };
    EXPECT_GT(brightness({-0.5f, 0.6f, 0.7f}), brightness({0.5f, -0.6f, 0.6f}) + 0.3f) << name;
  }
}

TEST(LitSpheres, OnesOwnIsTheLargestSquareInTheMiddle) {
  Image picture{300, 200, {"R", "G", "B", "A"}, {}};
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 300; ++x) {
      bool isInside = x >= 50 && x < 250;
      picture.pixels.insert(picture.pixels.end(), {isInside ? 1.0f : 0.0f, float(y) / 199.0f, 0.0f, 1.0f});
    }
  Image fitted = fitLitSphere(picture);
  ASSERT_EQ(fitted.width, kLitSphereSize);
  ASSERT_EQ(fitted.channels.size(), 3u);
  EXPECT_EQ(fitted.pixels[0], 1.0f);
  EXPECT_EQ(fitted.pixels[std::size_t(kLitSphereSize - 1) * 3], 1.0f);
  EXPECT_LT(fitted.pixels[1], 0.02f);
  EXPECT_THROW(fitLitSphere(Image{}), ArgumentError);
}

TEST(Finishes, EachIsFoundByItsNameAgain) {
  std::set<std::string_view> names;
  for (const auto& finish : finishes()) {
    Scene scene;
    scene.finish.spheres.resize(1);
    scene.finish.spheres[0].name = "mine";
    applyFinish(scene, finish.name);
    EXPECT_EQ(finishName(scene), finish.name);
    EXPECT_EQ(scene.finish.spheres.size(), 1u) << "the user's own stay";
    EXPECT_TRUE(isLitSphere(scene.finish, scene.finish.sphere)) << finish.name;
    EXPECT_EQ(addsAnything(scene.finish), finish.name != "none");
    names.insert(finish.name);
  }
  EXPECT_EQ(names.size(), finishes().size());
  EXPECT_GE(names.size(), 8u);
  Scene scene;
  EXPECT_EQ(finishName(scene), "none");
  scene.finish.contourWidth = 3.25;
  EXPECT_EQ(finishName(scene), "");
  EXPECT_THROW(applyFinish(scene, "crayon"), ArgumentError);
}

TEST(Finishes, NoneGivesBackTheLinesOfAModelsLook) {
  for (const NamedModelLook& look : modelLooks()) {
    Scene scene;
    applyModelLook(scene, look.name);
    Scene before = scene;
    EXPECT_EQ(finishName(scene), "none") << look.name;
    for (const auto& finish : finishes()) {
      applyFinish(scene, finish.name);
      EXPECT_EQ(finishName(scene), finish.name);
      scene.lighting.shadow = 0.123;  // by hand
      applyFinish(scene, "none");
      EXPECT_EQ(scene.finish, before.finish) << look.name << ", " << finish.name;
    }
  }
}

TEST(Finishes, ALookOfModelsAndAFinishHaveNoNameInCommon) {
  for (const auto& finish : finishes())
    for (const auto& look : modelLooks()) {
      EXPECT_NE(finish.name, look.name);
      EXPECT_NE(finish.title, look.title);
    }
}

TEST(ModelLooks, TheFirstIsKnownByItsOldName) {
  Scene scene;
  applyModelLook(scene, "plate");
  EXPECT_EQ(modelLookName(scene), kFirstModelLook);
  applyPreset(scene, "soft");
  applyPreset(scene, "plate");
  EXPECT_EQ(modelLookName(scene), kFirstModelLook);
}

TEST(ModelLooks, EachIsFoundByItsNameAgainUntilOneOfItsValuesIsAnother) {
  std::set<std::string_view> names;
  for (const NamedModelLook& look : modelLooks()) {
    Scene scene;
    scene.finish.spheres.resize(1);
    scene.finish.spheres[0].name = "mine";
    applyModelLook(scene, look.name);
    EXPECT_EQ(modelLookName(scene), look.name);
    EXPECT_TRUE(isModelLook(look.name));
    EXPECT_EQ(scene.finish.spheres.size(), 1u) << "the user's own stay";
    names.insert(look.name);
    auto with = [&](auto change) {
      Scene other = scene;
      change(other);
      return modelLookName(other);
    };
    EXPECT_EQ(with([](Scene& s) {
                s.lighting.occlusion *= 0.5;
                s.lighting.occlusion += 0.01;
              }),
              "")
        << look.name;
    EXPECT_EQ(with([](Scene& s) {
                s.background.top.r *= 0.5f;
                s.background.top.g += 0.01f;
              }),
              "")
        << look.name;
    EXPECT_EQ(with([](Scene& s) { s.model.nearColors += 0.013; }), "") << look.name;
    EXPECT_EQ(with([](Scene& s) { s.finish.contourWidth += 0.013; }), "") << look.name;
    EXPECT_EQ(with([](Scene& s) { s.camera.height += 1.0; }), look.name) << "no part of it";
  }
  EXPECT_EQ(names.size(), modelLooks().size());
  EXPECT_GE(names.size(), 3u);
  EXPECT_TRUE(isModelLook(kFirstModelLook));
  EXPECT_FALSE(isModelLook("crayon"));
  Scene scene;
  EXPECT_THROW(applyModelLook(scene, "crayon"), ArgumentError);
}

TEST(NamedTable, WhoMistypesANameIsToldTheNearestAndAll) {
  Scene scene;
  auto refusal = [](auto apply) -> std::string {
    try {
      apply();
    } catch (const ArgumentError& error) {
      return error.what();
    }
    return {};
  };
  std::string text = refusal([&] { applyFinish(scene, "pencl"); });
  EXPECT_TRUE(text.starts_with("no finish 'pencl' (is 'pencil' meant?); there are none, plate, ")) << text;
  EXPECT_TRUE(text.ends_with(", x-ray")) << text;
  EXPECT_EQ(refusal([&] { applyModelLook(scene, "sofd"); }),
            "no look of models 'sofd' (is 'soft' meant?); there are painted, soft, technical");
  EXPECT_TRUE(
      refusal([&] { applyPreset(scene, "ct-bones"); }).starts_with("no preset 'ct-bones' (is 'ct-bone' meant?)"));
  EXPECT_TRUE(refusal([&] { makeLitSphere("qqqqqq"); }).starts_with("no lit sphere 'qqqqqq'; there are pencil, "));
}

TEST(Finishes, SpheresThatNobodyHasAreNamed) {
  Scene scene;
  scene.labels.structures.resize(3);
  scene.labels.structures[0].litSphere = "bone";
  scene.labels.structures[1].litSphere = scene.labels.structures[2].litSphere = "crayon";
  EXPECT_EQ(unknownLitSpheres(scene), std::vector<std::string>{"crayon"});
}

}  // namespace
}  // namespace velum::scene
