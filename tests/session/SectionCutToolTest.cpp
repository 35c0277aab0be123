#include "session/cut/SectionCutTool.h"

#include <gtest/gtest.h>

#include "CutScene.h"
#include "membrane/sheet/SheetIndex.h"
#include "session/cut/SectionContour.h"
#include "session/cut/ShapeTraits.h"
#include "shared/cut.h"
#include "sheetShapes.h"

namespace velum::session {

namespace {

const glm::dvec2 kSectionCutToolSize(500, 400);

/// Sections along the axes and a turned one, through the middle and off it.
std::vector<scene::SectionPlane> manySections() {
  std::vector<scene::SectionPlane> frames;
  scene::Scene scene = boxScene(kSectionCutToolSize);
  scene::placeSections(scene);
  for (double turn : {0.0, 0.5}) {
    scene::turnSections(scene, scene::SectionKind::Axial, turn);
    scene::turnSections(scene, scene::SectionKind::Sagittal, turn * 0.7);
    for (auto kind : {scene::SectionKind::Axial, scene::SectionKind::Coronal, scene::SectionKind::Sagittal})
      frames.push_back(scene::makeSectionPlane(scene, kind, kSectionCutToolSize));
  }
  return frames;
}

double distanceMm(const scene::Cut& cut, glm::dvec3 world) {
  glm::dvec3 local(glm::inverse(scene::worldFromCut(cut)) * glm::dvec4(world, 1.0));
  return shared::cutShapeDistance(static_cast<int>(cut.shape), glm::vec3(cut.size * 0.5), glm::vec3(local));
}

std::vector<scene::Cut> manyCuts() {
  std::vector<scene::Cut> cuts;
  for (auto shape : everyShapeButMembranes()) cuts.push_back(tiltedCut(shape));
  for (auto shape : everyShapeButMembranes()) {
    scene::Cut cut = tiltedCut(shape);
    cut.axis = {0, 0, 1};
    cut.spinDeg = 0;
    if (shape == scene::CutShape::Cone) cut.centre.z -= 20;
    cuts.push_back(cut);
  }
  return cuts;
}

}  // namespace

TEST(SectionCutTool, TheOutlineLiesOnTheShapeAndOnTheSection) {
  int lines = 0;
  for (const auto& frame : manySections())
    for (const auto& cut : manyCuts()) {
      SectionOutline outline = sectionOutline(frame, cut);
      lines += !outline.points.empty();
      // A rim of 180 corners leaves the curve by 1.6e-4 of its radius; floats add a little.
      for (const auto& p : outline.points)
        EXPECT_NEAR(distanceMm(cut, scene::worldFromSectionPixel(frame, p)), 0.0, 0.02) << enumName(cut.shape);
    }
  EXPECT_GT(lines, 45);
}

TEST(SectionCutTool, TheCurvesOfAMembraneLieOnItsSheetAndAreTakenHoldOf) {
  scene::Cut cut = tiltedCut(scene::CutShape::Membrane);
  cut.membrane->shape = wavySheet({30, 30}, cut.size);
  membrane::SheetIndex index = membrane::makeSheetIndex(cut.membrane->shape, {30, 30}, cut.size);
  shared::SheetPlan plan{{0, 30, 30, 0}, glm::vec3(cut.size * 0.5), 1.0f};
  int corners = 0, held = 0;
  for (const auto& frame : manySections()) {
    SectionOutline outline = sectionOutline(frame, cut);
    EXPECT_TRUE(outline.points.empty() || !outline.curves.empty()) << "the sheet hangs in its frame";
    for (const auto& curve : outline.curves)
      for (const auto& p : curve) {
        glm::dvec3 world = scene::worldFromSectionPixel(frame, p);
        glm::vec3 local(glm::dvec3(glm::inverse(scene::worldFromCut(cut)) * glm::dvec4(world, 1.0)));
        EXPECT_NEAR(shared::sheetDistance(plan, local, {index.rows.data()}), 0.0f, 0.02f);
        ++corners;
        held += sectionHandleAt(frame, cut, p, 9.0).kind != SectionHandleKind::None;
      }
  }
  EXPECT_GT(corners, 100);
  EXPECT_EQ(held, corners);
}

TEST(SectionCutTool, AMembraneIsHeldByTheLineOfItsFrame) {
  scene::Cut cut = tiltedCut(scene::CutShape::Membrane);
  int ends = 0, arrows = 0;
  for (const auto& frame : manySections()) {
    SectionOutline outline = sectionOutline(frame, cut);
    auto localOf = [](const scene::Cut& held, glm::dvec3 world) {
      return glm::dvec3(glm::inverse(scene::worldFromCut(held)) * glm::dvec4(world, 1.0));
    };
    for (glm::dvec2 p : outline.points) {
      glm::dvec3 local = glm::abs(localOf(cut, scene::worldFromSectionPixel(frame, p)));
      EXPECT_NEAR(local.z, 0.0, 1e-9);
      EXPECT_NEAR(std::max(local.x - 30, local.y - 20), 0.0, 1e-9) << "it ends on the frame";
    }
    for (const auto& handle : sectionHandles(frame, cut)) {
      glm::dvec2 to = handle.place + handle.outwards * 9.0;
      scene::Cut now = dragSectionCut(cut, frame, handle, handle.place, to);
      EXPECT_EQ(dragSectionCut(cut, frame, handle, handle.place, handle.place), cut);
      glm::dvec3 before = localOf(cut, scene::worldFromSectionPixel(frame, handle.place));
      glm::dvec3 after = localOf(now, scene::worldFromSectionPixel(frame, to));
      EXPECT_NEAR(before.z, 0.0, 1e-9);
      if (handle.kind == SectionHandleKind::Face) {
        ++ends;
        EXPECT_NEAR(after[handle.axis] * handle.sign, now.size[handle.axis] * 0.5, 1e-6);
        glm::dvec3 far(0.0);
        far[handle.axis] = -handle.sign * cut.size[handle.axis] * 0.5;
        glm::dvec3 stays = localOf(now, glm::dvec3(scene::worldFromCut(cut) * glm::dvec4(far, 1.0)));
        EXPECT_NEAR(stays[handle.axis] * handle.sign, -now.size[handle.axis] * 0.5, 1e-9);
      } else if (isArrow(handle)) {
        ++arrows;
        EXPECT_NEAR(after.z, 0.0, 1e-6) << "the frame goes with the pointer";
        EXPECT_LT(glm::length(glm::cross(now.centre - cut.centre, cutFrame(cut)[2])), 1e-9);
      }
    }
  }
  EXPECT_GT(ends, 8);
  EXPECT_GT(arrows, 4);
}

TEST(SectionCutTool, TheOutlineGoesRoundTheWholeShape) {
  // Every point inside the shape lies inside the outline, and the other way round.
  for (const auto& frame : manySections())
    for (const auto& cut : manyCuts()) {
      SectionOutline outline = sectionOutline(frame, cut);
      if (!outline.isClosed) continue;
      for (int y = 5; y < 400; y += 13)
        for (int x = 5; x < 500; x += 13) {
          glm::dvec2 p(x, y);
          double mm = distanceMm(cut, scene::worldFromSectionPixel(frame, p));
          if (std::abs(mm) < 0.1) continue;
          bool inside = false;
          auto look = [&](const std::vector<glm::dvec2>& line) {
            for (std::size_t i = 0; i < line.size(); ++i) {
              glm::dvec2 a = line[i], b = line[(i + 1) % line.size()];
              if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
            }
          };
          look(outline.points);
          for (const auto& curve : outline.curves) look(curve);
          EXPECT_EQ(inside, mm < 0) << enumName(cut.shape) << " at " << x << ", " << y;
        }
    }
}

TEST(SectionCutTool, AnOutlineByDistanceGoesRoundAnyShape) {
  int closed = 0;
  for (const auto& frame : manySections())
    for (const auto& cut : manyCuts()) {
      auto curves = shapeContour(frame, cut);
      for (const auto& curve : curves) {
        closed += curve.front() == curve.back();
        for (const auto& p : curve) EXPECT_NEAR(distanceMm(cut, scene::worldFromSectionPixel(frame, p)), 0.0, 0.01);
      }
      for (int y = 5; y < 400; y += 13)
        for (int x = 5; x < 500; x += 13) {
          glm::dvec2 p(x, y);
          double mm = distanceMm(cut, scene::worldFromSectionPixel(frame, p));
          if (std::abs(mm) < 2.0 * frame.lengthPerPixel || cut.shape == scene::CutShape::Plane) continue;
          bool inside = false;
          for (const auto& curve : curves)
            for (std::size_t i = 1; i < curve.size(); ++i) {
              glm::dvec2 a = curve[i - 1], b = curve[i];
              if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
            }
          EXPECT_EQ(inside, mm < 0) << enumName(cut.shape) << " at " << x << ", " << y;
        }
    }
  EXPECT_GT(closed, 30);
}

TEST(SectionCutTool, ThePlanesLineEndsAtTheViewAndKnowsItsRemovedSide) {
  for (const auto& frame : manySections()) {
    scene::Cut plane = tiltedCut(scene::CutShape::Plane);
    for (bool invert : {false, true}) {
      plane.invert = invert;
      SectionOutline outline = sectionOutline(frame, plane);
      ASSERT_EQ(outline.points.size(), 2u);
      for (glm::dvec2 p : outline.points) {
        EXPECT_GE(std::min(p.x, p.y), -1e-6);
        EXPECT_LE(p.x, kSectionCutToolSize.x + 1e-6);
        EXPECT_LE(p.y, kSectionCutToolSize.y + 1e-6);
      }
      glm::dvec2 beside = (outline.points[0] + outline.points[1]) * 0.5 + outline.removedSide * 5.0;
      bool removed = (distanceMm(plane, scene::worldFromSectionPixel(frame, beside)) < 0) != invert;
      EXPECT_TRUE(removed);
    }
  }
}

TEST(SectionCutTool, ACutBesideTheSectionHasNeitherLineNorHandles) {
  auto frame = manySections()[0];
  for (auto shape : everyClosedShape()) {
    scene::Cut cut = tiltedCut(shape);
    cut.centre += frame.normal * 500.0;
    EXPECT_TRUE(sectionOutline(frame, cut).points.empty());
    EXPECT_TRUE(sectionHandles(frame, cut).empty());
  }
  scene::Cut along = tiltedCut(scene::CutShape::Plane);
  along.axis = frame.normal;
  EXPECT_TRUE(sectionHandles(frame, along).empty());
}

TEST(SectionCutTool, EveryHandleIsFoundWhereItIs) {
  int handlesFound = 0;
  for (const auto& frame : manySections())
    for (const auto& cut : manyCuts()) {
      auto handles = sectionHandles(frame, cut);
      if (cut.shape != scene::CutShape::Plane && handles.empty()) continue;
      for (const auto& handle : handles) EXPECT_EQ(sectionHandleAt(frame, cut, handle.place, 0.25).kind, handle.kind);
      handlesFound += int(handles.size());
    }
  EXPECT_GT(handlesFound, 100);
}

TEST(SectionCutTool, AHandleStaysUnderThePointer) {
  for (const auto& frame : manySections())
    for (const auto& cut : manyCuts())
      for (const auto& handle : sectionHandles(frame, cut)) {
        glm::dvec2 to = handle.place + handle.outwards * 9.0;
        if (handle.kind == SectionHandleKind::Turn || handle.outwards == glm::dvec2(0.0))
          to = handle.place + glm::dvec2(6, 4);
        scene::Cut now = dragSectionCut(cut, frame, handle, handle.place, to);
        EXPECT_NE(now, cut);
        glm::dvec3 world = scene::worldFromSectionPixel(frame, to);
        if (handle.kind == SectionHandleKind::Face) {
          // As far under the face that it holds as it was: in its plane where that is flat. It may have left the disc
          // of a slanted end.
          auto under = [&](const scene::Cut& c, glm::dvec3 place) {
            const ShapeTraits& traits = traitsOf(c.shape);
            double along = handle.axis != 2 ? 0.5 : handle.sign > 0 ? traits.high : -traits.low;
            return along * c.size[handle.axis] - glm::dot(place - c.centre, cutFrame(c)[handle.axis]) * handle.sign;
          };
          double before = under(cut, scene::worldFromSectionPixel(frame, handle.place));
          EXPECT_NEAR(under(now, world), before, 1e-6);
          if (traitsOf(cut.shape).isWire) {
            EXPECT_NEAR(before, 0.0, 1e-6);
          }
        } else if (handle.kind == SectionHandleKind::Side) {
          // The held piece of a round shape is a chord of its rim: a hundredth of a millimetre inside.
          double before = distanceMm(cut, scene::worldFromSectionPixel(frame, handle.place));
          EXPECT_NEAR(distanceMm(now, world), before, 0.02) << enumName(cut.shape);
        } else if (handle.kind == SectionHandleKind::Move && cut.shape == scene::CutShape::Plane) {
          EXPECT_NEAR(distanceMm(now, world), 0.0, 1e-3);
        } else if (handle.kind == SectionHandleKind::Move) {
          glm::dvec3 shift = world - scene::worldFromSectionPixel(frame, handle.place);
          EXPECT_LT(glm::length(now.centre - cut.centre - shift), 1e-9);
        } else if (cut.shape == scene::CutShape::Plane) {
          EXPECT_NEAR(distanceMm(now, world), 0.0, 1e-3);
        }
        EXPECT_EQ(dragSectionCut(cut, frame, handle, handle.place, handle.place), cut);
      }
}

TEST(SectionCutTool, ResizingAFaceLeavesTheOppositeOneWhereItIs) {
  for (const auto& frame : manySections())
    for (const auto& cut : manyCuts())
      for (const auto& handle : sectionHandles(frame, cut)) {
        if (handle.kind != SectionHandleKind::Face || cut.shape != scene::CutShape::Box) continue;
        scene::Cut now = dragSectionCut(cut, frame, handle, handle.place, handle.place + glm::dvec2(7, -5));
        glm::dvec3 out = cutFrame(cut)[handle.axis] * double(handle.sign);
        double before = glm::dot(cut.centre, out) - cut.size[handle.axis] * 0.5;
        EXPECT_NEAR(glm::dot(now.centre, out) - now.size[handle.axis] * 0.5, before, 1e-9);
      }
}

TEST(SectionCutTool, ShiftTurnsBySteps) {
  auto frame = manySections()[1];
  scene::Cut plane = tiltedCut(scene::CutShape::Plane);
  CutSnap snap{true, glm::dmat3(10.0)};
  auto handle = sectionHandles(frame, plane)[0];
  ASSERT_EQ(handle.kind, SectionHandleKind::Turn);
  glm::dvec2 arm = handle.place - handle.pivot;
  glm::dvec2 to = handle.pivot + glm::dvec2(arm.x * std::cos(0.6) - arm.y * std::sin(0.6),
                                            arm.x * std::sin(0.6) + arm.y * std::cos(0.6));
  scene::Cut now = dragSectionCut(plane, frame, handle, handle.place, to, snap);
  // 0.6 rad are 34 degrees: 30 are kept to, about the section's normal.
  glm::dvec3 n = frame.normal, a = glm::normalize(plane.axis), b = now.axis;
  a -= n * glm::dot(a, n);
  b -= n * glm::dot(b, n);
  EXPECT_NEAR(glm::degrees(std::acos(glm::dot(glm::normalize(a), glm::normalize(b)))), 30.0, 1e-6);
}

}  // namespace velum::session
