// A thread for each instance of some copies, and what has become of it: model::InstanceStates.
#include "model/kept.glsl"

// Bits of an instance: view.stateWords words of those that cuts have removed; as many of those that hide a focus; as many of
// those that some pixel shows.
layout(std430, binding = kStateBinding) buffer StateBlock { uint states[]; };

layout(location = 0) uniform int firstIndex;  // of this dispatch, instances of a copy
layout(location = 1) uniform int endIndex;
layout(location = 2) uniform int firstSlot;   // a row of groups is a slot of a copy

uint stateBit(uint instance) { return 1u << (instance & 31u); }
bool isRemoved(uint instance) { return (states[instance >> 5] & stateBit(instance)) != 0u; }
