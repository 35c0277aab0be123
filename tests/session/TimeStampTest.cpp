// The time of a time step over pictures.
#include "session/lettering/TimeStamp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/Text.h"
#include "lettered.h"
#include "scene/Scene.h"
#include "session/lettering/Lettering.h"
#include "vector/Letters.h"

namespace velum::session {

TEST(TimeStamps, TellStepsApartWithTheSameDigitsForAllAndAreRight) {
  for (double seconds :
       {1e-7, 2.5e-6, 4e-4, 0.0025, 0.004, 0.01, 1.0 / 30, 0.06, 0.25, 0.5, 1.0, 1.5, 2.0, 10.0, 90.0, 600.0})
    for (int steps : {2, 10, 300}) {
      std::set<std::string> all;
      std::string unit, first = timeText(0, steps, seconds);
      for (int i = 0; i < steps; ++i) {
        std::string text = timeText(i, steps, seconds);
        EXPECT_TRUE(all.insert(text).second) << text << " of " << seconds;
        auto decimals = [](const std::string& of) {
          return of.find('.') == of.npos ? 0 : of.find(' ') - of.find('.') - 1;
        };
        EXPECT_EQ(decimals(text), decimals(first));
        std::string name = text.substr(text.find(' ') + 1);
        if (unit.empty()) unit = name;
        EXPECT_EQ(name, unit) << "the unit changes";
        double scale = name == "h"     ? 3600
                       : name == "min" ? 60
                       : name == "s"   ? 1
                       : name == "ms"  ? 1e-3
                       : name == "ns"  ? 1e-9
                                       : 1e-6;
        double value = 0.0, last = scale * std::pow(10.0, -double(decimals(text)));
        std::string_view rest = text;
        if (name == "h" || name == "min") last *= name == "h" ? 1.0 / 3600 : 1.0 / 60;
        for (double part = scale; !rest.empty() && rest[0] != ' '; part /= 60.0) {
          value += *takeNumber(rest) * part;
          if (!rest.empty() && rest[0] == ':') rest.remove_prefix(1);
        }
        EXPECT_LE(std::abs(value - i * seconds), 0.5001 * last + 1e-12) << text;
      }
    }
  EXPECT_EQ(timeText(7, 10, 0.06), "0.42 s");
  EXPECT_EQ(timeText(3, 10, 0.005), "15 ms");
  EXPECT_EQ(timeText(1, 200, 60.0), "0:01:00 h");
  EXPECT_EQ(timeText(125, 200, 1.0), "2:05 min");
  EXPECT_EQ(timeText(2, 5, 0.5), "1.0 s");
}

TEST(TimeStamps, SayTheStepWhereNobodyKnowsItsTimeAndNothingWithoutTime) {
  scene::Scene scene = captioned({});
  scene.volume.timeStep = 2;
  EXPECT_EQ(timeStampOf(scene)->text, "0.12 s");
  Volume volume = *scene.volume.data;
  for (double seconds : {0.0, -1.0, std::nan(""), 1e300}) {
    volume.timeStepSeconds = seconds;
    scene.volume.data = Shared<Volume>(volume);
    EXPECT_EQ(timeStampOf(scene)->text, "step 3 of 10");
  }
  volume.timeSteps = 1;
  scene.volume.data = Shared<Volume>(volume);
  EXPECT_FALSE(timeStampOf(scene));
  scene.lettering.timeStamp = true;
  EXPECT_TRUE(letteringBlocks(scene, {640, 360}, {}).empty());
  EXPECT_FALSE(timeStampOf(scene::Scene()));
}

TEST(TimeStamps, StandStillWhileTimeGoesOn) {
  scene::Scene scene = captioned({});
  scene.lettering.timeStamp = true;
  for (double seconds : {0.0, 0.3, 2.0, 30.0}) {
    Volume volume = *scene.volume.data;
    volume.timeSteps = 120;
    volume.timeStepSeconds = seconds;
    scene.volume.data = Shared<Volume>(volume);
    for (int corner = 0; corner < 4; ++corner) {
      scene.lettering.timeStampCorner = scene::Corner(corner);
      scene.volume.timeStep = 0;
      auto endOf = [&] {
        auto blocks = letteringBlocks(scene, {640, 360}, {});
        const auto& words = std::get<vector::Words>(blocks.at(0).items.at(0));
        return words.start + glm::dvec2(vector::Letters(words.font, words.em).width(words.text), 0.0);
      };
      glm::dvec2 first = endOf();
      for (int step : {1, 9, 10, 99, 119}) {
        scene.volume.timeStep = step;
        EXPECT_NEAR(glm::distance(endOf(), first), 0.0, 1e-9);
      }
    }
  }
}

}  // namespace velum::session
