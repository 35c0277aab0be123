#pragma once
#include <string>

#include "Report.h"

namespace velum::bench {

struct Options {
  bool quick = false;    ///< Fewer positions and sizes: a look, not a measurement.
  bool tune = false;     ///< The half of the planes on which constants may be chosen; the other half is reported.
  std::string match;     ///< Of the families only data that has this in its name.
  std::string planes;    ///< Of the families a file (CSV) of planes: what is in it is not measured again. Empty: none.
  std::string pictures;  ///< Folder for the pictures that were compared; empty: none.
};

/// The same scenes by VTK's mappers and by ours, pictures compared. Needs an X display for VTK.
void measureAgainstVtk(const Options& options, Report& report);
/// First coarse picture, moving camera, edits, longest piece of work.
void measureInteraction(const Options& options, Report& report);
/// From an edit of labels to its picture, and the same with all labels sent.
void measureLabels(const Options& options, Report& report);
/// Growing regions against ITK, and slab by slab against the paper's figures.
void measureGrowing(const Options& options, Report& report);
/// Structures pulled out of cuts: the paper's Table 1.
void measureCrossSections(const Options& options, Report& report);
/// What the visibility equalizer costs a frame, how soon a handle answers, and how both grow.
void measureEqualizer(const Options& options, Report& report);
/// Frame time against voxels, pixels, opacity, cuts and structures.
void measureScaling(const Options& options, Report& report);
/// Trilinear fetches: what the driver can do and what our frames ask of it.
void measureFetches(const Options& options, Report& report);
/// Our readers against ITK's and VTK's, time and memory.
void measureLoading(const Options& options, Report& report);

/// Volumes larger than memory: membranes, terabytes, sections; a volume that fits, streamed and in memory.
void measureStreaming(const Options& options, Report& report);
/// Membranes over a virtual phantom of vessels of 40 GB: until at rest, what they keep whole against the limit.
void measureStreamedMembranes(const Options& options, Report& report);
/// A virtual terabyte and one of real files: opened, flown through, memory.
void measureTerabytes(const Options& options, Report& report);

/// The membrane: the time of a step and of an edit, and the table that follows.
void measureMembrane(const Options& options, Report& report);
/// Pictures a second with volumes, kernels and sheet as large as in the paper's Table 1.
void measureMembraneTable(const Options& options, Report& report);
/// How soon a membrane follows whoever drags its frame.
void measureMembraneDrag(const Options& options, Report& report);

/// What a picture costs with a finer sheet.
void measureFineSheets(const Options& options, Report& report);
/// How much of what is protected the sheets keep whole, against the limit.
void measureKeptWhole(const Options& options, Report& report);
/// The same by kinds of data, with ways to protect, sizes and oblique frames: hours.
void measureFamilies(const Options& options, Report& report);

}  // namespace velum::bench
