// What fields() says of single fields, by their paths.
#include "scene/json/FieldFacts.h"

#include <gtest/gtest.h>

#include "core/Error.h"
#include "scene/json/Schema.h"

namespace velum::scene {
namespace {

TEST(FieldFacts, AreThoseOfTheTableOfFields) {
  for (const FieldRow& row : fieldTable()) {
    FieldFacts facts = fieldFacts(row.path);
    EXPECT_EQ(facts.meaning, row.doc) << row.path;
    EXPECT_EQ(facts.unit, row.unit) << row.path;
    EXPECT_EQ(facts.kind == FieldKind::Truth, row.type == "true or false") << row.path;
    EXPECT_EQ(facts.kind == FieldKind::Text, row.type == "text") << row.path;
    EXPECT_EQ(facts.kind == FieldKind::Choice, row.type.starts_with('`')) << row.path;
    EXPECT_EQ(facts.kind == FieldKind::Choice, !facts.names.empty()) << row.path;
  }
}

TEST(FieldFacts, OfAVectorTellHowManyAndOfAColourThatItIsOne) {
  FieldFacts particles = fieldFacts("cuts.N.membrane.cloth.particles");
  EXPECT_EQ(particles.kind, FieldKind::Whole);
  EXPECT_EQ(particles.count, 2);
  EXPECT_EQ(particles.range.max, 260.0);
  EXPECT_EQ(fieldFacts("finish.contourColor").kind, FieldKind::Color);
  EXPECT_EQ(fieldFacts("lighting.keyDirection").kind, FieldKind::Number);
}

TEST(FieldFacts, AnItemIsSaidByItsPlaceOrItsNameOrNotAtAll) {
  for (const char* path : {"cuts.N.faceOpacity", "cuts.3.faceOpacity", "cuts[Plane 1].faceOpacity"})
    EXPECT_EQ(fieldFacts(path).meaning, fieldFacts("cuts.N.faceOpacity").meaning) << path;
}

TEST(FieldFacts, OfWhatNoSceneHasAreRefused) {
  for (const char* path : {"finish.contour", "finish.contours.x", "cuts.N.fac", "nothing"})
    EXPECT_THROW(fieldFacts(path), ArgumentError) << path;
}

}  // namespace
}  // namespace velum::scene
