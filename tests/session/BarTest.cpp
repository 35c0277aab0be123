// The handle of a bar: what it sets, shows and takes back, whatever is left.
#include "session/Bar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace velum::session {

namespace {

/// A document with a cut whose size is what is left.
class BarTest : public testing::Test {
 protected:
  void SetUp() override {
    scene::Scene scene;
    scene::Cut cut;
    cut.id = 4;
    scene.cuts = {cut};
    scene.model.types = {{.type = "hidden one", .visible = false}};
    mDocument.replace(std::move(scene));
    mBefore = mDocument.scene();
  }

  /// Of 100 things of which so many are seen and hidden; the solver leaves no odd number.
  Bar::Hold hold(Bar::Handle handle, std::uint64_t seen, std::uint64_t hidden) {
    Counts start{{seen, hidden, 100 - seen - hidden}};
    return {"Set number", handle, start, 100, [scene = mDocument.scene()](double left) {
              Solved solved{scene, {4}, std::uint64_t(std::clamp(left, 0.0, 100.0)), 0, "so many"};
              solved.reached = solved.wanted / 2 * 2;
              solved.scene.cuts[0].size = glm::dvec3(double(solved.reached));
              solved.scene.model.types.clear();
              return solved;
            }};
  }
  double leftInScene() const { return mDocument.scene().cuts[0].size.x; }

  Document mDocument;
  scene::Scene mBefore;
  Bar mBar{mDocument};
};

}  // namespace

TEST_F(BarTest, WhatIsSeenIsExpectedToBeTheSameShareOfWhatIsLeft) {
  mBar.take(hold(Bar::Handle::Left, 20, 40));
  EXPECT_EQ(mBar.now(), (Counts{{20, 40, 40}})) << "as it was, until it is moved";
  EXPECT_EQ(mBar.moveTo(31.0), "so many");
  EXPECT_EQ(mBar.now(), (Counts{{10, 20, 70}})) << "of what the solver has come to";
  mBar.letGo();
  mBar.take(hold(Bar::Handle::Left, 0, 0));
  mBar.moveTo(8.0);
  EXPECT_EQ(mBar.now(), (Counts{{8, 0, 92}})) << "all, where nothing is known";
}

TEST_F(BarTest, AHandleOfWhatIsSeenLeavesAsManyMoreAndAsksPictures) {
  mBar.take(hold(Bar::Handle::Seen, 10, 30));
  mBar.moveTo(20.0);
  EXPECT_EQ(leftInScene(), 80.0);
  auto wish = mBar.letGo();
  ASSERT_TRUE(wish.has_value());
  EXPECT_EQ(wish->seen, 20u);
  EXPECT_EQ(wish->cuts, std::vector<int>{4});
  EXPECT_EQ(wish->label, "Set number");
  mBar.take(hold(Bar::Handle::Seen, 0, 30));
  mBar.moveTo(20.0);
  EXPECT_EQ(leftInScene(), 50.0) << "where none is seen, so many more";
  mBar.giveUp();
  mBar.take(hold(Bar::Handle::Seen, 10, 30));
  EXPECT_FALSE(mBar.letGo()) << "it was not moved";
  mBar.take(hold(Bar::Handle::Left, 10, 30));
  mBar.moveTo(20.0);
  EXPECT_FALSE(mBar.letGo()) << "what is left is known";
}

TEST_F(BarTest, AHoldIsOneStepAndTheNextAnother) {
  for (int i = 0; i < 2; ++i) {
    mBar.take(hold(Bar::Handle::Left, 20, 40));
    for (double to : {50.0, 40.0, 30.0 + 4.0 * i}) mBar.moveTo(to);
    EXPECT_TRUE(mBar.isMoved());
    mBar.letGo();
    EXPECT_FALSE(mBar.isHeld());
  }
  EXPECT_EQ(mDocument.undoLabels().size(), 2u);
  mDocument.undo();
  EXPECT_EQ(leftInScene(), 30.0);
  mDocument.undo();
  EXPECT_EQ(mDocument.scene(), mBefore);
}

TEST_F(BarTest, GivenUpAllIsAsBefore) {
  mBar.take(hold(Bar::Handle::Left, 20, 40));
  mBar.moveTo(50.0);
  EXPECT_TRUE(mDocument.scene().model.types.empty()) << "what a handle needs is shown";
  mBar.giveUp();
  EXPECT_EQ(mDocument.scene(), mBefore);
  EXPECT_TRUE(mDocument.undoLabels().empty());
  EXPECT_EQ(mBar.moveTo(10.0), "") << "nobody holds it";
  EXPECT_EQ(mDocument.scene(), mBefore);
}

TEST(DialGap, HasSoManyThresholdsUpToItAndNoOtherNumberIsNearer) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    Dial dial;
    for (std::size_t count = random() % 30; dial.candidates.size() < count;)
      dial.candidates.push_back({float(random() % 20) / 20.0f, std::uint32_t(dial.candidates.size())});
    std::uint64_t all = dial.candidates.size();
    auto upTo = [&](float threshold) {
      return std::uint64_t(std::count_if(dial.candidates.begin(), dial.candidates.end(),
                                         [&](const Candidate& one) { return one.from <= threshold; }));
    };
    for (std::uint64_t wanted = 0; wanted <= all + 1; ++wanted) {
      DialGap gap = gapFor(dial, wanted);
      auto off = [&](std::uint64_t staying) { return std::abs(double(staying) - double(wanted)); };
      if (gap.staying > 0) {
        EXPECT_EQ(upTo(gap.last), gap.staying);
        EXPECT_LT(gap.last, gap.next);
      }
      EXPECT_EQ(std::isinf(gap.next), gap.staying == all && all > 0);
      EXPECT_LE(off(gap.staying), off(0));
      for (const Candidate& one : dial.candidates) EXPECT_LE(off(gap.staying), off(upTo(one.from)));
    }
  }
}

TEST(Counts, TablesHaveAColumnForEachKind) {
  Counts counts;
  for (std::size_t i = 0; i < kCountKinds.size(); ++i) counts.parts[i] = i + 1;
  std::string columns = countColumns(), fields = countFields(counts);
  EXPECT_EQ(columns, "visible,hidden,clipped,total");
  EXPECT_EQ(fields, "1,2,3,6");
  EXPECT_EQ(std::count(columns.begin(), columns.end(), ','), std::ptrdiff_t(kCountKinds.size()));
  EXPECT_EQ(counts.left(), 3u);
  bool wasLeft = true;
  for (const CountKind& kind : kCountKinds) {
    EXPECT_TRUE(wasLeft || !kind.isLeft) << "what is left comes first: " << kind.name;
    wasLeft = kind.isLeft;
  }
}

}  // namespace velum::session
