// Instances as they are seen, from who is nearest in each pixel: colour by palette, light, fog. [VE] 8.1.
layout(local_size_x = 8, local_size_y = 8) in;

#include "common/frame.glsl"
#include "model/instances.glsl"

layout(std140, binding = kInstanceShadeBinding) uniform InstanceShadeBlock { InstanceShade shade; };
layout(std430, binding = kOwnerBinding) readonly buffer OwnerBlock { uint owners[]; };
layout(std430, binding = kBallBinding) readonly buffer BallBlock { uint balls[]; };
layout(binding = kDepthUnit) uniform usamplerBuffer depthTexture;
layout(binding = kOpenUnit) uniform sampler2D openTexture;
layout(binding = kTypeUnit) uniform samplerBuffer typeTexture;
layout(binding = kBallKindUnit) uniform usamplerBuffer ballKindTexture;

// What the surfaces were drawn into.
layout(binding = kSurfaceColorImage, rgba16f) uniform writeonly image2D colorImage;
layout(binding = kSurfaceAuxImage, rgba32f) uniform image2D auxImage;  // normal, distance along the ray
layout(binding = kSurfaceIdImage, rgba32ui) uniform uimage2D idImage;  // structure, instance, what a contour goes around, how large it is

layout(location = 0) uniform ivec2 corner;  // of this dispatch

// Sizes are in pixels of a picture of 1000 rows, so that pictures of any size look alike.
float unitsPerLength(float depth) { return pixelsPerLength(depth) * 1000.0 / view.pictureSize.y; }

// Radius from which on an instance has a line around it.
const float kLeastOutlined = 1.5;
// Radii between which molecules come to shade each other in full: what small ones do is grain.
const float kLeastShading = 4.5;
const float kFullShading = 18.0;

/// A ball in its place, from the eye.
struct Placed {
  vec3 middle;
  float radius;
  int number;
};

Placed placedBall(Place place, uint number) {
  vec4 ball = texelFetch(ballTexture, int(number));
  return Placed(place.position - view.eye.xyz + turned(place.rotation, ball.xyz), ball.w, int(number));
}

float missOf(Placed ball, vec3 hit) { return abs(length(hit - ball.middle) / ball.radius - 1.0); }

/// A ball of a whole copy, as if it were a molecule by itself.
MoleculeRow rowOfBall(Place place, Placed ball) {
  MoleculeRow row = moleculeAt(place.molecule);
  row.sphere = texelFetch(ballTexture, ball.number);
  uvec2 kind = texelFetch(ballKindTexture, ball.number).rg;
  row.type = kind.x | kind.y << 8;
  return row;
}

/// The ball that a pixel shows: where two instances were as near, it may be noted of the other one.
Placed shownBall(Place place, MoleculeRow molecule, uint number, vec3 hit) {
  Placed best = placedBall(place, number);
  float least = missOf(best, hit);
  if (least < 0.02) return best;
  uint from = levelAt(molecule.firstLevel).first;
  LevelRow last = levelAt(molecule.firstLevel + molecule.levelCount - 1u);
  uint end = last.first + last.count;
  least = 1e30;
  for (uint i = from; i < end; ++i) {
    Placed ball = placedBall(place, i);
    float miss = missOf(ball, hit);
    if (miss < least) {
      best = ball;
      least = miss;
    }
  }
  return best;
}

// Elements as chemists colour them, calmer.
vec3 elementColor(uint element, vec3 plain) {
  if (element == 6u) return vec3(0.62, 0.61, 0.60);
  if (element == 7u) return vec3(0.40, 0.50, 0.83);
  if (element == 8u) return vec3(0.83, 0.36, 0.33);
  if (element == 15u) return vec3(0.90, 0.60, 0.25);
  if (element == 16u) return vec3(0.90, 0.80, 0.32);
  if (element == 1u) return vec3(0.90, 0.90, 0.89);
  return plain;
}

/// Chains of a molecule as lighter and darker tones of its colour.
vec3 chainColor(uint chain, vec3 plain) {
  float turn = fract(float(chain) * 0.6180339887) - 0.5;
  vec3 toward = turn > 0.0 ? vec3(1.0) : plain * plain;
  return chain == 0u ? plain : mix(plain, toward, abs(turn) * 0.9);
}

vec3 albedoOf(uint type, int ball, bool isOfWhole, float nearest) {
  vec3 plain = texelFetch(typeTexture, int(type)).rgb;
  uvec2 kind = isOfWhole ? uvec2(0u) : texelFetch(ballKindTexture, ball).rg;
  if (shade.palette == kPaletteElement) return elementColor(kind.x, mix(plain, vec3(0.62, 0.61, 0.60), 0.35));
  if (shade.palette == kPaletteChain) return chainColor(kind.y, plain);
  // [VE] 2.2: far off a colour a type, near by shades of it for chains, nearer for elements.
  float pixels = pixelsPerLength(nearest) * shade.angstrom;
  vec3 out_ = mix(plain, chainColor(kind.y, plain), shade.nearColors * smoothstep(0.6, 2.0, pixels));
  return mix(out_, mix(out_, elementColor(kind.x, out_), 0.6), shade.nearColors * smoothstep(3.0, 8.0, pixels));
}

// How much it counts that where nothing is known nothing hides the light: next to nothing, beside a place that lies as deep.
const float kAlone = 1e-4;

/// Openness and share of the key light, from the four places about a pixel where they are known: those count that lie as deep.
vec2 lightOn(ivec2 pixel, float depth) {
  ivec2 last = textureSize(openTexture, 0) - 1;
  vec2 place = vec2(pixel - shade.openShift) / float(kOpenStep);
  ivec2 from = ivec2(floor(place));
  vec2 part = place - vec2(from);
  vec3 sum = vec3(kAlone);
  for (int i = 0; i < 4; ++i) {
    ivec2 at = ivec2(i & 1, i >> 1);
    vec4 there = texelFetch(openTexture, clamp(from + at, ivec2(0), last), 0);
    vec2 share = mix(1.0 - part, part, vec2(at));
    float apart = abs(there.z - depth) * min(pixelsPerLength(depth), unitsPerLength(depth));
    sum += vec3(there.xy, 1.0) * (share.x * share.y + 0.02) / (1.0 + apart * apart);
  }
  return sum.xy / sum.z;
}

// Radii of balls from which on, and up to which, each has its own light: smaller ones would be grain.
const float kLeastLit = 2.0;
const float kFullLit = 7.0;
// How much more than by that a finish is told that a molecule faces the eye: it is not as round as the sphere around it.
const float kFlatter = 0.8;
// How much of their neighbours' shade falls on molecules of a few pixels.
const float kLeastShaded = 0.45;

/// How far a ball has its own light, 0..1.
float ownLight(Placed ball, float depth) { return smoothstep(kLeastLit, kFullLit, ball.radius * unitsPerLength(depth)); }

/// By which a place on a ball is lit: of the molecule's whole shape, where balls are small.
vec3 litNormal(Placed ball, Place place, MoleculeRow molecule, vec3 hit, vec3 own, float depth) {
  vec3 middle = place.position - view.eye.xyz + turned(place.rotation, molecule.sphere.xyz);
  float share = ownLight(ball, depth);
  return normalize(mix((hit - middle) / molecule.sphere.w, own, share) + 1e-6 * own);
}

/// A colour in less light: darker, and no greyer, as a painter would mix it.
vec3 shaded(vec3 rgb, float light) { return rgb * sqrt(light) * pow(max(rgb, vec3(1e-3)), vec3(0.8 * (1.0 - light))); }

/// What a pixel shows of an instance.
void shadePixel(ivec2 pixel, int at, uint owner) {
  float depth = uintBitsToFloat(texelFetch(depthTexture, at).r);
  vec3 offset;
  vec3 ray = rayOf(pixel, offset);
  vec3 hit = offset + depth * ray;  // from the eye
  bool isOfWhole = isWhole(owner);
  Place place;
  MoleculeRow molecule;
  Placed ball;
  if (isOfWhole) {
    place = wholePlace(owner);
    ball = placedBall(place, balls[at]);
    molecule = rowOfBall(place, ball);
  } else {
    place = placeOf(owner);
    molecule = moleculeAt(place.molecule);
    ball = shownBall(place, molecule, balls[at], hit);
  }
  vec3 normal = normalize(hit - ball.middle);
  vec3 toEye = -normalize(ray);
  vec3 rgb = albedoOf(molecule.type, ball.number, isOfWhole, depth);
  float size = molecule.sphere.w * unitsPerLength(depth);
  vec3 side = litNormal(ball, place, molecule, hit, normal, depth);
  if (hasFlag(kFlagShaded)) {
    vec2 known = lightOn(pixel, depth);
    // What molecules of a few pixels do to each other is grain, too.
    known = mix(vec2(1.0), known, mix(kLeastShaded, 1.0, smoothstep(kLeastShading, kFullShading, size)));
    float open = mix(1.0, known.x, frame.occlusionStrength);
    float lit = mix(1.0, known.y, frame.shadowStrength);
    float sky = 0.85 + 0.15 * dot(side, frame.pictureUp.xyz);
    float lambert = max(dot(side, frame.keyLight.xyz), 0.0);
    vec3 halfway = normalize(frame.keyLight.xyz + toEye);
    float highlight = pow(max(dot(normal, halfway), 0.0), frame.shininess) * step(1e-4, lambert);
    // Shadows tint the light from everywhere, too: that is most of it in flat pictures.
    vec3 ambient = shaded(rgb, open * mix(1.0, lit, 0.35)) * (frame.ambient * sky);
    rgb = ambient + rgb * (frame.diffuse * lambert * lit * mix(1.0, open, 0.5)) + vec3(frame.specular * highlight * lit);
  }
  float up = (float(pixel.y) + view.shift.y) / view.pictureSize.y;
  vec3 behind = mix(shade.fogTop.rgb, shade.fogBottom.rgb, up);
  float fog = shade.fog * smoothstep(0.0, 1.0, (depth - shade.fogNear) / max(shade.fogFar - shade.fogNear, 1e-9));
  imageStore(colorImage, pixel, vec4(mix(rgb, behind, fog), 1.0));
  imageStore(auxImage, pixel, vec4(normalize(side + kFlatter * (1.0 - ownLight(ball, depth)) * toEye), depth * length(ray)));
  // Small ones of a type have no lines between them: there would be nothing else.
  uint structure = shade.firstType + molecule.type;
  uint group = size < kLeastOutlined || isOfWhole ? structure : shade.firstInstance + owner;
  uint number = shade.firstInstance + (isCrowd() ? copyNumber(owner) : owner);
  imageStore(idImage, pixel, uvec4(structure, number, group, floatBitsToUint(2.0 * molecule.sphere.w * min(unitsPerLength(depth), pixelsPerLength(depth)))));
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + corner;
  if (any(greaterThanEqual(pixel, view.size))) return;
  int at = pixel.y * view.size.x + pixel.x;
  uint owner = owners[at];
  if (owner == kNoInstance) return;
  // A surface may be nearer.
  uint there = imageLoad(idImage, pixel).g;
  if (there != 0u) {
    vec3 offset;
    vec3 ray = rayOf(pixel, offset);
    float depth = uintBitsToFloat(texelFetch(depthTexture, at).r);
    if (imageLoad(auxImage, pixel).w <= depth * length(ray)) return;
  }
  shadePixel(pixel, at, owner);
}
