// What the passes of the finish are told.
#ifndef VELUM_SHARED_FINISH_H
#define VELUM_SHARED_FINISH_H
#include "shared/types.h"
SHARED_BEGIN

SHARED_CONST int kSphereTexels = 128;    // edge of a lit sphere
SHARED_CONST float kCellPeriods = 1.6f;  // edge of a cell of strokes, in distances from stroke to stroke

struct FinishParams {
  vec4 contourColor;  ///< rgb
  vec4 paperColor;    ///< rgb

  float contours;  ///< strength
  float contourShare;  ///< of a line that is thinner than the pixels next to an edge
  float creases;
  float steps;
  float structures;
  float litSphere;  ///< share of its colour
  float hatching;   ///< strength
  float strokePixels;  ///< from stroke to stroke
  float cellPixels;    ///< edge of a cell of strokes
  float paperGrain;
  float unitsPerPixel;  ///< pixels of a picture of 1000 rows in one of this
  float paperUnits;  ///< the same in units of the paper, which may be larger

  int reach;       ///< pixels to the neighbours that are looked at for contours
  int sphereRows;  ///< lit spheres in their texture
  int cellsX;      ///< cells of strokes that the window meets
  int cellsY;
  int firstCellX;  ///< the first of them, counted in the whole picture
  int firstCellY;
  float stepLength;  ///< a jump of depth begins to count from there, scene units
  float deepStep;    ///< of a model: a jump of depth that has a strong line, scene units
  float strongReach;  ///< of a model: as far from an edge a strong line reaches, pixels,
  float fineReach;    ///< and a fine one
  float padding0;
  float padding1;
};

SHARED_END
#endif
