#pragma once
#include <string>
#include <utility>
#include <vector>

#include "scene/Scene.h"

/// Scenes of every kind. The files in tests/scene/v1 hold them as version 1 of the format wrote them.
namespace velum::scene::kinds {

/// Planes, enabled or not, inverted, with the data's grey values on the face, with structures that they leave whole.
inline Scene planes() {
  Scene scene;
  Cut plane;
  plane.name = "Front";
  plane.centre = {10.5, -20.25, 30};
  plane.axis = {0.25, -1, 0.5};
  plane.face = CutFace::Section;
  plane.faceOpacity = 0.75;
  plane.spares = {{0}, {3}, {65535}};
  scene.cuts.push_back(plane);
  Cut off;
  off.name = "Off \xc3\xa4 \"quoted\"";
  off.enabled = false;
  off.invert = true;
  off.spares = {{7}};
  scene.cuts.push_back(off);
  scene.cuts.push_back({});
  return scene;
}

/// Closed shapes.
inline Scene shapes() {
  Scene scene;
  Cut cut;
  cut.axis = {0.1, 0.2, 0.9};
  cut.centre = {1, 2, 3};
  cut.size = {40, 30.5, 20};
  cut.spinDeg = 33.5;
  for (CutShape shape : {CutShape::Box, CutShape::Sphere, CutShape::Cylinder, CutShape::Cone}) {
    cut.shape = shape;
    cut.invert = shape == CutShape::Cylinder;
    scene.cuts.push_back(cut);
  }
  scene.cuts[1].spares = {{12}};
  return scene;
}

/// A passive membrane by the paper's rule, with everything that hands and curves put on one.
inline Scene passive() {
  Scene scene;
  Cut cut;
  cut.name = "Sheet";
  cut.shape = CutShape::Membrane;
  cut.size = {120, 80, 25};
  cut.spares = {{2}};
  Membrane membrane;
  membrane.field.byValue = {{-200, 0}, {100, 250.5}, {300, -40}};
  membrane.field.byGradient = {{0, 0}, {50, 10}};
  membrane.field.byLabel = {{4, 100}, {9, -50}};
  membrane.field.level = 2;
  membrane.field.threshold = 1.5;
  membrane.field.areaOfEffect = 3;
  membrane.field.rule = KernelRule::Paper;
  membrane.field.kernels = {{{1, 2, 3}, 12.5, -300}, {{4, 5, 6}, 8, 500}};
  membrane.field.strokes = {{{{0, 0, 0}, {1, 2, 3}}, 4.5, false}, {{{9, 8, 7}}, 2, true}};
  membrane.field.byValueBefore = {{0, 1}};
  membrane.cloth.particles = {30, 40};
  membrane.cloth.finest = 100;
  membrane.cloth.stretch = 0.8;
  membrane.cloth.bend = 0.2;
  membrane.cloth.restoring = 20;
  membrane.cloth.damping = 6;
  membrane.cloth.timeStepS = 0.01;
  membrane.cloth.iterations = 12;
  membrane.pins = {{{0.25, 0.75}, {3, 2, 1}}, {{0.5, 0.5}, {-3, -2, -1}}};
  membrane.look = SheetLook::Grid;
  cut.membrane = membrane;
  scene.cuts.push_back(cut);
  return scene;
}

/// An active membrane that has come to rest.
inline Scene active() {
  Scene scene;
  Cut cut;
  cut.shape = CutShape::Membrane;
  cut.axis = {0, 0, 1};
  Membrane membrane;
  membrane.cloth.finest = 260;
  membrane.repositioning = Repositioning::Active;
  membrane.look = SheetLook::Surface;
  membrane.shape.particles = {2, 2};
  membrane.shape.places = {{-50, -50, 0}, {50, -50, 1.5}, {-50, 50, 2.25}, {50, 50, 0}};
  membrane.shape.centre = {0, 0, 4};
  membrane.shape.axis = {0, 0, 1};
  membrane.shape.spinDeg = 5;
  membrane.shape.timeStep = 3;
  cut.membrane = membrane;
  scene.cuts.push_back(cut);
  return scene;
}

/// A membrane whose use is an image with what lies next to it, one with nothing but defaults, and a plane.
inline Scene inlay() {
  Scene scene;
  Cut cut;
  cut.shape = CutShape::Membrane;
  cut.spares = {{0}};
  Membrane membrane;
  membrane.cloth.finest = 260;
  membrane.use = MembraneUse::Inlay;
  membrane.inlayOpacity = 0.5;
  membrane.emphasis = -0.5;
  membrane.falloff = 12;
  cut.membrane = membrane;
  scene.cuts.push_back(cut);
  Cut plain;
  plain.shape = CutShape::Membrane;
  plain.membrane = Membrane{};
  scene.cuts.push_back(plain);
  scene.cuts.push_back({});
  return scene;
}

/// Looks of a volume, labels, surfaces, camera, light, views.
inline Scene looks() {
  Scene scene;
  scene.volume.source.path = "data/torso.nrrd";
  scene.volume.source.series = "1.2.3";
  scene.volume.source.spacing = {0.5, 0.5, 2};
  scene.volume.source.fingerprint = "123-abc";
  scene.volume.source.raw = {{64, 32, 16}, SampleType::Int16, 2, true, 512};
  scene.volume.timeStep = 3;
  scene.volume.channel = 1;
  scene.volume.transfer.preset = "ct-bone";
  scene.volume.transfer.colors = {{-100, {0.5f, 0.25f, 0.125f}}, {900, {1, 1, 1}}};
  scene.volume.transfer.opacities = {{0, 0}, {200, 0.75}};
  scene.volume.transfer.gradientOpacities = {{0, 0.5}, {40, 1}};
  scene.volume.transfer.unitDistance = 2.5;
  ChannelLook look;
  look.name = "DAPI";
  look.visible = false;
  look.color = {0, 0, 1};
  look.transfer.unitDistance = 0.25;
  look.windowLevel = 100;
  look.windowWidth = 50;
  scene.volume.channels = {look, ChannelLook{}};
  scene.volume.windowLevel = 40;
  scene.volume.windowWidth = 400;
  scene.labels.source.path = "data/labels.nii.gz";
  scene.labels.visible = false;
  scene.labels.tint = 0.25;
  scene.labels.unlabelled = 0.5;
  scene.labels.structures = {{3, "aorta", {1, 0, 0}, 0.5, true}, {7, "", {0, 1, 0}, 1, false}};
  Surface surface;
  surface.source.path = "data/implant.stl";
  surface.color = {0.25f, 0.5f, 0.75f};
  surface.visible = false;
  scene.surfaces = {surface};
  scene.camera.projection = Projection::Orthographic;
  scene.camera.eye = {1, -300, 20};
  scene.camera.target = {4, 5, 6};
  scene.camera.up = {0, 0.5, 1};
  scene.camera.fieldOfViewDeg = 45;
  scene.camera.height = 250;
  scene.sections.layout = Layout::FourUp;
  scene.sections.beside = SectionKind::Coronal;
  scene.sections.isPlaced = true;
  scene.sections.crosshair = {7, 8, 9};
  scene.sections.axial.pan = {3, -4};
  scene.sections.sagittal.height = 150;
  scene.sections.labelOpacity = 0.5;
  scene.sections.interpolate = false;
  scene.rayCast.mode = RenderMode::Iso;
  scene.rayCast.isoValue = 300;
  scene.rayCast.stepVoxels = 0.25;
  scene.lighting.shadow = 0.75;
  scene.background.bottom = {0.5f, 0.5f, 0.5f};
  scene.showBounds = true;
  return scene;
}

/// Every kind by the name of its file.
inline std::vector<std::pair<std::string, Scene>> all() {
  std::vector<std::pair<std::string, Scene>> kinds{{"planes", planes()}, {"shapes", shapes()}, {"passive", passive()},
                                                   {"active", active()}, {"inlay", inlay()},   {"looks", looks()}};
  for (auto& [name, scene] : kinds)
    for (auto& cut : scene.cuts) cut.id = nextCutId(scene);
  return kinds;
}

}  // namespace velum::scene::kinds
