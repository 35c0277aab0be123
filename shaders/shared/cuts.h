// What all cuts of a scene leave together. C++ and GLSL compile this text, and whoever wants to know asks it: the ray caster,
// the light grid, surfaces, inlays, kept voxels, exports.
//
// A cut removes a point of a structure where the point lies deeper in the cut's removed side than the cut spares the
// structure. Inlays (membranes whose use is an inlay with what lies next to it) add up: one of them that keeps a point is
// enough. Of all other cuts each takes what it removes; cuts that are joined to the one before them are one in this, which
// removes what each of them removes.
#ifndef VELUM_SHARED_CUTS_H
#define VELUM_SHARED_CUTS_H
#include "shared/cut.h"
SHARED_BEGIN

/// Cells along each edge of the grid that says which cuts matter where.
SHARED_CONST int kCutGrid = 16;

SHARED_FN bool cutIsInlay(CutData cut) { return cut.kind.x == kCutMembrane && cut.kind.w == kMembraneInlay; }

/// What a cut is to others, of kFold*.
SHARED_CONST int kFoldAlone = 0;
SHARED_CONST int kFoldInlay = 1;
SHARED_CONST int kFoldJoined = 2;
SHARED_FN int cutPart(CutData cut) {
  if (cutIsInlay(cut)) return kFoldInlay;
  return (cut.kind.z & kCutJoined) != 0 ? kFoldJoined : kFoldAlone;
}

/// kCutKeeps or kCutRemoves: what a cut does with a point.
/// @param depth  how deep in its removed side the cut leaves what is there, scene frame; 0: not at all; kCutFar: all of it
/// @param hasDepths  false where no spare ends: what is spared is spared whole, and nobody has to know how deep it lies
SHARED_FN int cutAnswer(CutData cut, float depth, bool hasDepths, vec3 p SHARED_SHEETS) {
  bool removes = cutRemoves(cut, p SHARED_PASS_SHEETS);
  if (hasDepths && depth > 0.0f && depth < kCutFar) removes = removes && -cutDistance(cut, p SHARED_PASS_SHEETS) > depth;
  return removes && depth < kCutFar ? kCutRemoves : kCutKeeps;
}

/// What the cuts that have been looked at leave of a point.
struct CutFold {
  bool isRemoved;  ///< some cut that is no inlay removes it, before the last and those that it is joined to
  bool isNear;     ///< some of these has to be looked at closely
  int last;        ///< what the last cut that is no inlay does together with those that it is joined to
  bool hasInlay;
  bool inInlay;    ///< some inlay keeps it
  bool nearInlay;  ///< some inlay has to be looked at closely
};

SHARED_FN CutFold emptyFold() {
  CutFold fold;
  fold.isRemoved = false;
  fold.isNear = false;
  fold.last = kCutKeeps;
  fold.hasInlay = false;
  fold.inInlay = false;
  fold.nearInlay = false;
  return fold;
}

/// What joined cuts do together.
SHARED_FN int joinedAnswer(int a, int b) {
  if (a == kCutKeeps || b == kCutKeeps) return kCutKeeps;
  return a == kCutRemoves && b == kCutRemoves ? kCutRemoves : kCutNear;
}

/// Adds what one more cut does: kCutKeeps, kCutRemoves, or kCutNear where that is not known yet. @param part  cutPart()
SHARED_FN CutFold foldAnswer(CutFold fold, int part, int answer) {
  bool isInlay = part == kFoldInlay;
  fold.hasInlay = fold.hasInlay || isInlay;
  fold.inInlay = fold.inInlay || (isInlay && answer == kCutKeeps);
  fold.nearInlay = fold.nearInlay || (isInlay && answer == kCutNear);
  // The one before is as it is now, unless this one is joined to it.
  bool isAlone = part == kFoldAlone;
  fold.isRemoved = fold.isRemoved || (isAlone && fold.last == kCutRemoves);
  fold.isNear = fold.isNear || (isAlone && fold.last == kCutNear);
  int joined = part == kFoldJoined ? joinedAnswer(fold.last, answer) : fold.last;
  fold.last = isAlone ? answer : joined;
  return fold;
}

SHARED_FN bool foldRemoves(CutFold fold) { return fold.isRemoved || fold.last == kCutRemoves; }

/// Adds one more cut. @param depth  how deep the cut leaves what is at the point, 0: not at all; other parameters as of cutAnswer()
SHARED_FN CutFold foldCut(CutFold fold, CutData cut, int part, float depth, bool hasDepths, vec3 p SHARED_SHEETS) {
  return foldAnswer(fold, part, cutAnswer(cut, depth, hasDepths, p SHARED_PASS_SHEETS));
}

/// Whether the cuts together keep the point, where none is kCutNear.
SHARED_FN bool foldKeeps(CutFold fold) { return !foldRemoves(fold) && (fold.inInlay || !fold.hasInlay); }

/// The same as an answer, kCutNear where only a closer look tells.
SHARED_FN int foldSays(CutFold fold) {
  if (foldRemoves(fold) || (fold.hasInlay && !fold.inInlay && !fold.nearInlay)) return kCutRemoves;
  return fold.isNear || fold.last == kCutNear || (fold.hasInlay && !fold.inInlay) ? kCutNear : kCutKeeps;
}

#if SHARED_HAS_SHEETS
/// What cutAnswer() says, as far as one fetch tells; kCutNear where meshes of a sheet must be looked at.
SHARED_FN int cutGuess(CutData cut, float depth, bool hasDepths, vec3 p SHARED_SHEETS) {
  if (depth >= kCutFar) return kCutKeeps;
  if (cut.kind.x != kCutMembrane) {
    float distance = shapeDistance(cut, p);
    return distance < 0.0f && !(hasDepths && -distance <= depth) ? kCutRemoves : kCutKeeps;
  }
  int guess = membraneGuess(cut, vec3(cut.localFromScene * vec4(p, 1.0f)) SHARED_PASS_SHEETS);
  return hasDepths && depth > 0.0f && guess == kCutRemoves ? kCutNear : guess;
}

/// Share of its opacity that inlays leave to a point, that of the inlay that leaves it most: adds one more of them. What
/// it spares does not fade. @param depth  as of foldCut()
SHARED_FN float foldShare(float share, CutData cut, float depth, bool hasDepths, vec3 p SHARED_SHEETS) {
  bool isKept = cutAnswer(cut, depth, hasDepths, p SHARED_PASS_SHEETS) == kCutKeeps;
  float own = depth > 0.0f ? 1.0f : membraneShare(cut, vec3(cut.localFromScene * vec4(p, 1.0f)).z);
  return max(share, isKept ? own : 0.0f);
}
#endif

/// What the cuts that have been looked at do with a ray from t on, spares left out.
struct RunFold {
  CutFold at;           ///< with what follows t
  float removedTo;      ///< where the last of the parts ends that cuts, other than inlays, remove from t on
  int face;             ///< the cut on whose face that is
  int triangle;
  float next;           ///< where the first of them begins that does not hold t
  float inlayChange;    ///< where the first inlay changes
  int inlay;            ///< that one
  int inlayTriangle;
  CutRun last;          ///< of the last cut that is no inlay, with those that it is joined to; counted when it is known
  int lastFace;         ///< on whose face its run ends
  float from;           ///< t
};

SHARED_FN RunFold emptyRuns(float t) {
  RunFold fold;
  fold.at = emptyFold();
  fold.removedTo = t;
  fold.face = -1;
  fold.triangle = -1;
  fold.next = kCutFar;
  fold.inlayChange = kCutFar;
  fold.inlay = -1;
  fold.inlayTriangle = -1;
  fold.last.end = t;
  fold.last.next = kCutFar;
  fold.last.triangle = -1;
  fold.lastFace = -1;
  fold.from = t;
  return fold;
}

/// Counts the last cut, or those that are joined, when the next is another.
SHARED_FN RunFold foldLast(RunFold fold) {
  bool removes = fold.last.end > fold.from;
  bool isLast = fold.last.end > fold.removedTo;
  fold.removedTo = isLast ? fold.last.end : fold.removedTo;
  fold.triangle = isLast ? fold.last.triangle : fold.triangle;
  fold.face = isLast ? fold.lastFace : fold.face;
  fold.next = removes ? fold.next : min(fold.next, fold.last.next);
  return fold;
}

SHARED_FN RunFold foldRun(RunFold fold, int cut, int part, CutRun run, float t) {
  bool removes = run.end > t;
  bool isInlay = part == kFoldInlay;
  fold.at = foldAnswer(fold.at, part, removes ? kCutRemoves : kCutKeeps);
  float change = removes ? run.end : run.next;
  bool isFirst = isInlay && (fold.inlay < 0 || change < fold.inlayChange);
  fold.inlayChange = isFirst ? change : fold.inlayChange;
  fold.inlayTriangle = isFirst ? run.triangle : fold.inlayTriangle;
  fold.inlay = isFirst ? cut : fold.inlay;
  if (isInlay) return fold;
  if (part != kFoldJoined) {
    fold = foldLast(fold);
    fold.last = run;
    fold.lastFace = cut;
    return fold;
  }
  // Joined cuts remove up to where the first of them ends, and not before the last of those begins that keep.
  bool lastRemoves = fold.last.end > t;
  float begins = max(lastRemoves ? t : fold.last.next, removes ? t : run.next);
  bool isEnd = lastRemoves && removes && run.end < fold.last.end;
  fold.last.triangle = isEnd ? run.triangle : fold.last.triangle;
  fold.lastFace = isEnd ? cut : fold.lastFace;
  fold.last.end = lastRemoves && removes ? min(fold.last.end, run.end) : t;
  fold.last.next = lastRemoves && removes ? kCutFar : begins;
  return fold;
}

/// A stretch of a ray: all of it kept, or all of it removed by the cuts together.
struct Stretch {
  float end;     ///< where it ends, along the ray
  bool kept;
  int face;      ///< removed stretches: the cut on whose face they end
  int triangle;  ///< and, of a membrane, the triangle there; -1: none
};

/// The stretch that begins where the fold does.
SHARED_FN Stretch stretchOf(RunFold runs, float tEnd) {
  RunFold fold = foldLast(runs);
  bool isRemoved = foldRemoves(fold.at);
  Stretch stretch;
  stretch.kept = foldKeeps(fold.at);
  stretch.end = isRemoved ? fold.removedTo : min(fold.next, fold.inlayChange);
  stretch.end = min(stretch.end, tEnd);
  stretch.face = isRemoved ? fold.face : fold.inlay;
  stretch.triangle = isRemoved ? fold.triangle : fold.inlayTriangle;
  return stretch;
}

SHARED_END
#endif
