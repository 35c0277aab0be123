#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/Task.h"
#include "render/Renderer.h"
#include "scene/SceneFwd.h"
#include "scene/Sections.h"
#include "session/picture/Picture.h"
#include "vector/Drawing.h"

/// Plates: pictures in which lines stay lines and letters stay letters, in layers with names (.svg, .pdf).
namespace velum::session {

/// Pixels an inch on the page: as the options say, else by the width of the page that the scene's lettering has, else
/// 300.
double plateDpi(const scene::Scene& scene, const PictureOptions& options);

/// Draws a scene in the GL context that is current, as drawPicture() does, in layers from back to front: "paper",
/// "plate" (the picture alone, before nothing), "hatching", "contours", "cut lines", and those of the lettering.
/// Contours, hatching and cut lines are traced from what each pixel shows, with the widths of the finish; where
/// the finish has no contours those layers are hidden, and left out where they are large. Models have no faces of cuts.
/// @param scene  settled: with the shapes of its sheets
/// @throw Cancelled, gpu::GpuError
vector::Drawing drawPlate(render::Renderer& renderer, const scene::Scene& scene, const PictureOptions& options,
                          const gpu::Limits& limits, Progress& progress);

/// A section as layers: "plate", and those of the lettering. Without a graphics context. @throw Cancelled. Any thread.
vector::Drawing drawSectionPlate(const scene::Scene& scene, scene::SectionKind kind, const PictureOptions& options,
                                 Progress& progress);

/// Writes a plate with the scene inside, as savePicture() does with pictures of pixels.
/// @param path  see io::isDrawing()  @throw InputError when the disk refuses
void savePlate(const vector::Drawing& drawing, const scene::Scene& scene, const PictureOptions& options,
               const std::filesystem::path& path);

/// What journals refuse of a drawing, one line each, for people: pictures of less than 300 pixels an inch, lines of
/// less than half a point, letters of less than 6 points or more than 8. Empty: nothing.
std::vector<std::string> journalNotes(const vector::Drawing& drawing);

}  // namespace velum::session
