#pragma once
#include "scene/Scene.h"

namespace velum::session {

/// A moment on the way from the whole model to a scene with its cuts ([VE] fig. 4). In the first half, from S1 (nothing
/// is clipped) to S2 (cuts remove all that they reach), instances go one by one, each of them once: the share that
/// stays falls alike for all types, and so does the share of instances that hide a focus. In the second half, from S2
/// to S3 (the scene), the instances that the cuts' own rows leave come back: shares and falloffs grow to the rows'
/// values, and apertures close to them. A cut everywhere reaches all instances, and would remove all: its shares fall
/// only in the second half; in the first it clears the view alone. Volume, labels and surfaces go as soon as there are
/// cuts.
///
/// Without a model there are no instances to go one by one: in the first half flat cuts come in from where the data
/// ends and closed cuts grow to their size, in the second half structures come out of the cuts (pulledOut()).
/// @param at  0..1: at 0 there are no cuts, at 1 the scene is as it was
scene::Scene cutPathAt(scene::Scene scene, double at);

}  // namespace velum::session
