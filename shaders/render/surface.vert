// Triangles of a surface, and lines.
#include "common/frame.glsl"

layout(location = 0) in vec3 position;  // scene frame
layout(location = 1) in vec3 normal;

layout(location = 0) out vec3 scenePoint;
layout(location = 1) out vec3 sceneNormal;

void main() {
  scenePoint = position;
  sceneNormal = normal;
  gl_Position = frame.clipFromScene * vec4(scenePoint, 1.0);
}
