// Random numbers that are fixed for each instance.
#ifndef VELUM_SHARED_RANDOM_H
#define VELUM_SHARED_RANDOM_H
#include "shared/types.h"
SHARED_BEGIN

/// The finaliser of MurmurHash3, 32 bits.
SHARED_FN uint instanceBits(uint word) {
  uint x = word;
  x ^= x >> 16;
  x *= 0x85ebca6bu;
  x ^= x >> 13;
  x *= 0xc2b2ae35u;
  return x ^ (x >> 16);
}

/// 0 to before 1, fixed for each instance; several independent ones. What randomOf() of core says, too.
SHARED_FN float instanceRandom(uint instance, uint stream) {
  uint bits = instanceBits(instance + 0x9e3779b9u * (stream + 1u));
  return float(bits >> 8) * (1.0f / 16777216.0f);
}

SHARED_END
#endif
