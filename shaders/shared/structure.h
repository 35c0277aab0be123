// Whose a place among labels is, and how far inside. C++ and GLSL compile this text, and whoever wants to know asks it.
//
// Each of the eight voxels around a place votes for its own structure with its trilinear weight times its cover (0..1, see
// LabelCover): the structure with the most votes has the place. With shares of (1 + cover) / 2 for a voxel's own structure
// and the rest for another's the difference of two structures' interpolated shares is the difference of their votes: the
// border between two lies where both have half, three that meet share a line, and no place is nobody's or two's.
#ifndef VELUM_SHARED_STRUCTURE_H
#define VELUM_SHARED_STRUCTURE_H
#include "shared/types.h"
SHARED_BEGIN

SHARED_CONST uint kNobody = 0xffffffffu;

/// Who has a place.
struct Owner {
  uint id;         ///< label; kNobody when nobody has voted
  float coverage;  ///< share of the place that is the owner's where there are two: 1/2 on the border, 1 wholly inside
};

/// Votes for up to four structures: more than that do not meet but in a voxel of noise.
struct Votes {
  uint a, b, c, d;  ///< kNobody: free
  vec4 sums;
};

SHARED_FN Votes noVotes() {
  Votes votes;
  votes.a = votes.b = votes.c = votes.d = kNobody;
  votes.sums = vec4(0.0f);
  return votes;
}

SHARED_FN Votes addVote(Votes votes, uint id, float weight) {
  bool isA = votes.a == id || votes.a == kNobody;
  bool isB = !isA && (votes.b == id || votes.b == kNobody);
  bool isC = !isA && !isB && (votes.c == id || votes.c == kNobody);
  bool isD = !isA && !isB && !isC && (votes.d == id || votes.d == kNobody);
  votes.a = isA ? id : votes.a;
  votes.b = isB ? id : votes.b;
  votes.c = isC ? id : votes.c;
  votes.d = isD ? id : votes.d;
  votes.sums += vec4(isA ? weight : 0.0f, isB ? weight : 0.0f, isC ? weight : 0.0f, isD ? weight : 0.0f);
  return votes;
}

/// The smaller id where two have as much: whatever the order of the votes.
SHARED_FN Owner ownerOf(Votes votes) {
  uint id = votes.a;
  float most = votes.sums.x;
  float next = 0.0f;
  bool leads = votes.sums.y > most || (votes.sums.y == most && votes.b < id);
  next = max(next, min(most, votes.sums.y));
  id = leads ? votes.b : id;
  most = max(most, votes.sums.y);
  leads = votes.sums.z > most || (votes.sums.z == most && votes.c < id);
  next = max(next, min(most, votes.sums.z));
  id = leads ? votes.c : id;
  most = max(most, votes.sums.z);
  leads = votes.sums.w > most || (votes.sums.w == most && votes.d < id);
  next = max(next, min(most, votes.sums.w));
  id = leads ? votes.d : id;
  most = max(most, votes.sums.w);
  Owner owner;
  owner.id = id;
  owner.coverage = 0.5f + 0.5f * min(most - next, 1.0f);
  return owner;
}

SHARED_END
#endif
