// Triangles of a surface, pulled from a storage block.
#include "common/frame.glsl"

struct Vertex {
  vec4 position;  // scene frame
  vec4 normal;
};
layout(std430, binding = kMeshBinding) readonly buffer MeshBlock { Vertex vertices[]; };

layout(location = 0) out vec3 scenePoint;
layout(location = 1) out vec3 sceneNormal;

void main() {
  scenePoint = vertices[gl_VertexID].position.xyz;
  sceneNormal = vertices[gl_VertexID].normal.xyz;
  gl_Position = frame.clipFromScene * vec4(scenePoint, 1.0);
}
