// What the passes of the finish are told.
#ifndef VELUM_SHARED_FINISH_H
#define VELUM_SHARED_FINISH_H
#include "shared/types.h"
SHARED_BEGIN

SHARED_CONST int kSphereTexels = 128;    // edge of a lit sphere
// Lines of models: widths of strong and of fine ones, in the finish's width, and the radius of the circle of places that are
// asked for a line, in the line's own width: so the cover of all pixels has the width in sum.
SHARED_CONST float kStrongLine = 1.6f;
SHARED_CONST float kFineLine = 0.85f;
SHARED_CONST float kLineCircle = 0.606f;
// Half of the widest gap of an instance that is closed, pixels of a picture of 1000 rows.
SHARED_CONST float kCalmReach = 1.0f;
SHARED_CONST float kCellPeriods = 1.6f;  // edge of a cell of strokes, in distances from stroke to stroke

struct FinishParams {
  vec4 contourColor;  ///< rgb
  vec4 paperColor;    ///< rgb

  float contours;  ///< strength
  float contourPixels;  ///< their width
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
};

SHARED_END
#endif
