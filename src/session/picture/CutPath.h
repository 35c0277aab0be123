#pragma once
#include "scene/Scene.h"

namespace velum::session {

/// A moment on the way from the whole model to a scene with its cuts ([VE] fig. 4). In the first half, from S1 (nothing
/// is clipped) to S2 (cuts remove all that they reach), instances go one by one, each once: the share that stays falls
/// for all types alike, and so does that of those that hide a focus. In the second, from S2 to S3 (the scene), what the
/// cuts' own rows leave comes back: shares and falloffs grow to theirs, apertures close to theirs. A cut everywhere
/// reaches all, and would remove all: its shares fall in the second half, in the first it clears the view alone.
/// What is no model goes as soon as there are cuts.
///
/// Without a model nothing can go one by one: in the first half flat cuts come in from where the data ends and closed
/// ones grow to their size, in the second structures come out of them (pulledOut).
/// @param at  0..1: at 0 there are no cuts, at 1 the scene is as it was
scene::Scene cutPathAt(scene::Scene scene, double at);

}  // namespace velum::session
